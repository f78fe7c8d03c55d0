// Fabric against fabric: pairs of particle and panel are found once in each step and resolved in
// each substep.
//
// find() sizes the cells of a grid by the panels and by how far things move in a step (travel),
// sorts particles into hashed cells (sortParticles), and for each panel looks at the cells around
// it (findNear); consider() keeps the pairs that may come within a thickness of each other, and
// notes on which side the particle is. resolve() goes through the pairs in their order: it pushes
// the two apart and stops what closes the gap. All of it is on one thread, as pairs share
// particles; the list of pairs may take memory in a step when more come near each other than
// before.
#include "contact/fabric_contact.h"

#include "shapes/triangle_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

constexpr double mostCells = 16.0;   // cells across; wider panels are compared with all particles
constexpr double tornOut = 4.0;      // times the size at the start: the motion has blown up
constexpr double gravityReach = 1.5; // of the way at the speed of now: speeds change in a step
constexpr double keptBeside = 0.9; // of how far neighbours start apart, which a push brings closer
constexpr double leastUpright = 0.7; // cosine of the angle to the normal, of what lies on a panel

Corners cornersOf(const FabricPanel& panel, const std::vector<PaddedVec3>& x)
{
    return {x[std::size_t(panel.corner[0])], x[std::size_t(panel.corner[1])],
            x[std::size_t(panel.corner[2])]};
}

double extentOf(const Corners& x) // m
{
    const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]);
    const Vec3 high = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
    return (high - low).maxCoeff();
}

Vec3 normalOf(const Corners& x)
{
    const Vec3 area = (x[1] - x[0]).cross(x[2] - x[0]);
    const double twice = area.norm();
    return twice > 0.0 ? Vec3(area / twice) : Vec3(Vec3::Zero());
}

// How much of the way that they start apart by a particle keeps from a panel, 1.
double keptShare(const Vec3& apart, const Vec3& normal)
{
    return std::abs(apart.dot(normal)) > leastUpright * apart.norm() ? 1.0 : keptBeside;
}

// How far controls may carry particles in a step, m, which their velocities do not tell.
double carried(const System& system)
{
    double rate = 0.0; // m/s
    for (const Input& input : system.inputs)
        if (input.kind == ControlKind::Move)
            rate += input.rate;
    return rate * system.timeStep;
}

// A particle, the corners of a panel, and how a push between them is shared.
struct Meeting
{
    std::array<std::size_t, 4> who; // the particle first
    std::array<double, 4> share;    // 1, and minus the shares of the corners
    double weight;                  // 1/kg, of them together

    Vec3 relative(const std::vector<PaddedVec3>& v) const
    {
        return share[0] * v[who[0]] + share[1] * v[who[1]] + share[2] * v[who[2]]
               + share[3] * v[who[3]];
    }
    // Changes the relative value by `change`, shared out by inverse masses.
    void push(const std::vector<double>& inverseMass, const Vec3& change,
              std::vector<PaddedVec3>& v) const
    {
        for (std::size_t k = 0; k < 4; ++k)
            v[who[k]] += (inverseMass[who[k]] * share[k] / weight) * change;
    }
};

// Takes away the velocity that closes the gap, and lets friction take from the rest.
void stopClosing(const Meeting& meeting, const std::vector<double>& inverseMass, const Vec3& normal,
                 double friction, std::vector<PaddedVec3>& velocity)
{
    const Vec3 relative = meeting.relative(velocity);
    const double closing = -relative.dot(normal);
    if (!(closing > 0.0))
        return;
    const Vec3 along = relative + closing * normal;
    const double sliding = along.norm();
    const double taken = sliding > 0.0 ? std::min(1.0, friction * closing / sliding) : 0.0;
    meeting.push(inverseMass, closing * normal - taken * along, velocity);
}

} // namespace

void FabricContact::find(const System& system, const State& state)
{
    m_pairs.clear();
    double thickest = 0.0;
    for (const FabricLayer& layer : system.fabricLayer)
        thickest = std::max(thickest, layer.thickness);
    if (thickest == 0.0)
        return;
    m_pairs.reserve(4 * state.position.size());

    double widest = 0.0, count = 0.0;
    for (const FabricPanel& panel : system.panels) {
        const Corners x = cornersOf(panel, state.position);
        widest += (x[1] - x[0]).cwiseAbs().maxCoeff();
        count += 1.0;
    }
    const double edge = count > 0.0 ? widest / count : 0.0;
    // The reach is bounded, as fabric whose motion diverges would look for partners everywhere.
    const double reach =
        2.0 * thickest + std::min(travel(system, state), std::max(4.0 * edge, 8.0 * thickest));
    m_cell = std::max(edge, reach);
    sortParticles(system, state);
    for (std::size_t i = 0; i < system.panels.size(); ++i)
        if (!state.panelGone[i]
            && system.fabricLayer[std::size_t(system.panels[i].corner[0])].thickness > 0.0)
            findNear(system, state, int(i), reach);
}

// How far apart two things may move in a step, m.
double FabricContact::travel(const System& system, const State& state) const
{
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    bool first = true;
    for (std::size_t i = 0; i < state.velocity.size(); ++i) {
        if (system.fabricLayer[i].thickness == 0.0)
            continue;
        const Vec3& v = state.velocity[i];
        low = first ? v : low.cwiseMin(v);
        high = first ? v : high.cwiseMax(v);
        first = false;
    }
    return gravityReach * system.timeStep * (high - low).norm() + carried(system);
}

FabricContact::Cell FabricContact::cellOf(const Vec3& place) const
{
    const auto number = [&](double x) {
        return int(std::clamp(std::floor(x / m_cell), -1e9, 1e9));
    };
    return {number(place.x()), number(place.y()), number(place.z())};
}

std::size_t FabricContact::bucketOf(const Cell& cell) const
{
    std::uint32_t hash = std::uint32_t(cell.x) * 73856093u ^ std::uint32_t(cell.y) * 19349663u
                         ^ std::uint32_t(cell.z) * 83492791u; // Teschner and others 2003
    hash ^= hash >> 15;
    return hash & std::uint32_t(m_start.size() - 2);
}

void FabricContact::sortParticles(const System& system, const State& state)
{
    const std::size_t n = state.position.size();
    std::size_t buckets = 16;
    while (buckets < 2 * n)
        buckets *= 2;
    m_cellOf.resize(n);
    m_sorted.resize(n);
    m_start.assign(buckets + 1, 0);
    int last = 0;
    const auto takesPart = [&](std::size_t i) {
        return system.fabricLayer[i].thickness > 0.0 && state.position[i].allFinite();
    };
    for (std::size_t i = 0; i < n; ++i)
        if (takesPart(i)) {
            m_cellOf[i] = cellOf(state.position[i]);
            ++m_start[bucketOf(m_cellOf[i])];
        }
    for (std::size_t b = 0; b <= buckets; ++b) // m_start says where each list ends
        m_start[b] = last += m_start[b];
    for (std::size_t i = n; i-- > 0;) // filling from behind, it comes to say where each list starts
        if (takesPart(i))
            m_sorted[std::size_t(--m_start[bucketOf(m_cellOf[i])])] = int(i);
}

void FabricContact::findNear(const System& system, const State& state, int panel, double reach)
{
    const Corners x = cornersOf(system.panels[std::size_t(panel)], state.position);
    const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]) - Vec3::Constant(reach);
    const Vec3 high = x[0].cwiseMax(x[1]).cwiseMax(x[2]) + Vec3::Constant(reach);
    if (!low.allFinite() || !high.allFinite())
        return;
    const auto look = [&](int particle) {
        const Vec3& place = state.position[std::size_t(particle)];
        if ((place.array() >= low.array()).all() && (place.array() <= high.array()).all())
            consider(system, state, particle, panel);
    };
    if ((high - low).maxCoeff() > mostCells * m_cell) {
        const Corners start = cornersOf(system.panels[std::size_t(panel)], system.start.position);
        if (extentOf(x) <= tornOut * extentOf(start))
            std::for_each(m_sorted.begin(), m_sorted.begin() + m_start.back(), look);
        return;
    }
    const Cell first = cellOf(low), last = cellOf(high);
    for (int i = first.x; i <= last.x; ++i)
        for (int j = first.y; j <= last.y; ++j)
            for (int k = first.z; k <= last.z; ++k) {
                const std::size_t bucket = bucketOf({i, j, k});
                for (int s = m_start[bucket]; s < m_start[bucket + 1]; ++s) {
                    const int particle = m_sorted[std::size_t(s)];
                    if (m_cellOf[std::size_t(particle)] == Cell{i, j, k})
                        look(particle);
                }
            }
}

void FabricContact::consider(const System& system, const State& state, int particle, int panel)
{
    const FabricPanel& fabric = system.panels[std::size_t(panel)];
    const auto& corner = fabric.corner;
    if (std::find(corner.begin(), corner.end(), particle) != corner.end())
        return;
    const auto p = std::size_t(particle);
    const FabricLayer& one = system.fabricLayer[p];
    const FabricLayer& other = system.fabricLayer[std::size_t(corner[0])];
    const double thickness = 0.5 * (one.thickness + other.thickness);

    const Corners x = cornersOf(fabric, state.position);
    const Vec3 share = nearestShares(x, state.position[p]);
    const Vec3 apart = state.position[p] - atShares(x, share);
    const Vec3 closing = state.velocity[p] - atShares(cornersOf(fabric, state.velocity), share);
    const double distance = apart.norm();
    if (distance
        > 2.0 * thickness + gravityReach * system.timeStep * closing.norm() + carried(system))
        return;

    const Corners start = cornersOf(fabric, system.start.position);
    const Vec3& startPlace = system.start.position[p];
    const Vec3 startApart = startPlace - atShares(start, nearestShares(start, startPlace));
    const double kept =
        std::min(thickness, keptShare(startApart, normalOf(start)) * startApart.norm());
    if (!(kept > 1e-6 * thickness))
        return;
    const double side = apart.dot(normalOf(x)) < 0.0 ? -1.0 : 1.0;
    m_pairs.push_back({particle, panel, side, kept, std::min(one.friction, other.friction)});
}

void FabricContact::resolve(const System& system, State& state) const
{
    for (const Pair& pair : m_pairs) {
        if (state.panelGone[std::size_t(pair.panel)]) // it has gone since the pair was found
            continue;
        const auto& corner = system.panels[std::size_t(pair.panel)].corner;
        const auto p = std::size_t(pair.particle);
        const Corners x = cornersOf(system.panels[std::size_t(pair.panel)], state.position);
        const Vec3 share = nearestShares(x, state.position[p]);
        const Vec3 apart = state.position[p] - atShares(x, share);
        const Vec3 up = pair.side * normalOf(x);
        const double height = apart.dot(up);
        const bool isOver = share.minCoeff() > 0.0;
        // Beside the panel the distance is that to its rim; its other side is for its neighbours.
        double distance = height;
        Vec3 normal = up;
        if (!isOver) {
            distance = apart.norm();
            if (height < 0.0 || distance == 0.0)
                continue;
            normal = apart / distance;
        }
        if (distance >= pair.thickness)
            continue;

        Meeting meeting{{p, std::size_t(corner[0]), std::size_t(corner[1]), std::size_t(corner[2])},
                        {1.0, -share[0], -share[1], -share[2]},
                        0.0};
        for (std::size_t k = 0; k < 4; ++k)
            meeting.weight +=
                meeting.share[k] * meeting.share[k] * system.inverseMass[meeting.who[k]];
        if (meeting.weight == 0.0)
            continue;
        const double missing = std::min(pair.thickness - distance, pair.thickness);
        meeting.push(system.inverseMass, missing * normal, state.position);
        stopClosing(meeting, system.inverseMass, normal, pair.friction, state.velocity);
        if (isVerlet(system.integrator))
            stopClosing(meeting, system.inverseMass, normal, pair.friction, state.drift);
    }
}

} // namespace ripstop
