// Each panel is looked at by itself, in the order of System::membranes or of rows; sums are added
// in that order. Gradients of the corners are the rows of the inverse of the panel's shape, that of
// the first corner being minus the sum of the others.
#include "constraints/elastic_panels.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

using Mat2 = Eigen::Matrix2d;
using Gradient = std::array<double, 2>;

// How the strain changes as a corner moves, in the frame of where the warp and the weft have gone,
// 1/m: that of the warp by the first, of the weft by the second, the shear by both, crosswise.
struct StrainPerMove
{
    Gradient g;

    // In the places of one corner and of another, L^T C L'.
    Mat2 between(const Mat3& c, const StrainPerMove& other) const
    {
        const auto [a, b] = g;
        const auto [p, q] = other.g;
        Mat2 m;
        m(0, 0) = a * (c(0, 0) * p + c(0, 2) * q) + b * (c(2, 0) * p + c(2, 2) * q);
        m(0, 1) = a * (c(0, 1) * q + c(0, 2) * p) + b * (c(2, 1) * q + c(2, 2) * p);
        m(1, 0) = b * (c(1, 0) * p + c(1, 2) * q) + a * (c(2, 0) * p + c(2, 2) * q);
        m(1, 1) = b * (c(1, 1) * q + c(1, 2) * p) + a * (c(2, 1) * q + c(2, 2) * p);
        return m;
    }

    Vec3 of(const ClothAxes& axes, const Vec3& move) const
    {
        const double warp = axes[0].dot(move), weft = axes[1].dot(move);
        return {g[0] * warp, g[1] * weft, g[1] * warp + g[0] * weft};
    }

    Vec3 pull(const ClothAxes& axes, const Vec3& tension) const
    {
        return (g[0] * tension[0] + g[1] * tension[2]) * axes[0]
               + (g[1] * tension[1] + g[0] * tension[2]) * axes[1];
    }
};

// The nearest tension that pushes nowhere.
Vec3 pullingPart(const Vec3& tension)
{
    const double mean = 0.5 * (tension[0] + tension[1]);
    const double half = 0.5 * (tension[0] - tension[1]);
    const double radius = std::sqrt(half * half + tension[2] * tension[2]);
    if (mean >= radius)
        return tension;
    if (mean + radius <= 0.0)
        return Vec3::Zero();
    const double most = 0.5 * (mean + radius);
    return {most * (1.0 + half / radius), most * (1.0 - half / radius), most * tension[2] / radius};
}

Vec3 at(const Row& row) { return {row.v[0], row.v[1], row.v[2]}; }

ClothAxes axesWith(const Membrane& membrane, const ElasticPanel& panel,
                   std::span<const Row> position)
{
    const Vec3 a = at(position[panel.row[0]]);
    return axesOf(membrane, at(position[panel.row[1]]) - a, at(position[panel.row[2]]) - a);
}

// What a panel that gives way has in the matrix beside its law, of what it has when it is taut:
// cloth that folds switches between the two from one iteration to the next, and with nothing to
// resist that it goes too far each time.
constexpr double kept = 1e-3;

Mat3 tangentOf(const ClothLaw& law, const ClothTension& now)
{
    if (now.state == ClothState::Taut)
        return now.stiffness;
    return (1.0 - kept) * now.stiffness + kept * stiffnessOf(law);
}

// Whether there is something to pull and something to move.
bool takesPart(const System& system, const Membrane& membrane)
{
    return lawOf(system, membrane).isElastic()
           && std::ranges::any_of(
               system.panels[std::size_t(membrane.panel)].corner,
               [&](int corner) { return system.inverseMass[std::size_t(corner)] > 0.0; });
}

} // namespace

void ElasticPanels::prepare(const System& system, std::span<const std::uint32_t> row)
{
    m_panels.clear();
    for (std::size_t m = 0; m < system.membranes.size(); ++m) {
        const Membrane& membrane = system.membranes[m];
        if (!takesPart(system, membrane))
            continue;
        ElasticPanel panel;
        panel.membrane = int(m);
        for (std::size_t k = 0; k < 3; ++k)
            panel.row[k] = row[std::size_t(system.panels[std::size_t(membrane.panel)].corner[k])];
        m_panels.push_back(panel);
    }
}

bool ElasticPanels::areOf(const System& system) const
{
    const auto carries = [&](const Membrane& membrane) { return takesPart(system, membrane); };
    const auto stays = [&](const ElasticPanel& panel) {
        return std::size_t(panel.membrane) < system.membranes.size()
               && carries(system.membranes[std::size_t(panel.membrane)]);
    };
    return std::size_t(std::ranges::count_if(system.membranes, carries)) == m_panels.size()
           && std::ranges::all_of(m_panels, stays);
}

void ElasticPanels::sortByRow() { std::ranges::stable_sort(m_panels, {}, firstRow); }

void ElasticPanels::numberPairs(std::size_t nodes, std::vector<std::pair<int, int>>& pairs)
{
    for (ElasticPanel& panel : m_panels)
        ripstop::numberPairs(panel, nodes, pairs);
}

void ElasticPanels::start(const System& system, std::span<const std::uint8_t> gone,
                          const RodPast& past)
{
    for (ElasticPanel& panel : m_panels) {
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const ClothLaw law = lawOf(system, membrane);
        panel.gone = gone[std::size_t(membrane.panel)] != 0;
        const Corners corners = cornersOf(system, membrane, past.before);
        const Vec3 last = strainAt(membrane, corners);
        panel.offset.setZero();
        panel.weight = past.reach * past.reach * membrane.area;
        if (law.dampingTime == 0.0)
            continue;
        Vec3 pulling = pullingStrain(law, last);
        if (!past.drift.empty()) {
            const Corners way = cornersOf(system, membrane, past.drift);
            Corners back = corners;
            for (std::size_t k = 0; k < 3; ++k)
                back[k] -= past.h * way[k];
            pulling = (4.0 * pulling - pullingStrain(law, strainAt(membrane, back))) / 3.0;
        }
        const double share = law.dampingTime / (law.dampingTime + past.reach);
        panel.offset = share * pulling;
        panel.weight /= 1.0 - share;
    }
}

double ElasticPanels::energy() const
{
    double twice = 0.0;
    for (const ElasticPanel& panel : m_panels)
        if (!panel.gone)
            twice += 2.0 * panel.weight * panel.law.energy;
    return twice;
}

bool ElasticPanels::hasMoreThan(double twice, const System& system,
                                std::span<const Row> position) const
{
    for (const ElasticPanel& panel : m_panels) {
        if (panel.gone)
            continue;
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const Vec3 strain = strainOf(axesWith(membrane, panel, position)) - panel.offset;
        twice -= 2.0 * panel.weight * leastEnergyOf(lawOf(system, membrane), strain);
        if (twice < 0.0)
            return true;
    }
    return false;
}

double ElasticPanels::measure(const System& system, std::span<const Row> position)
{
    for (ElasticPanel& panel : m_panels) {
        if (panel.gone)
            continue;
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        panel.axes = axesWith(membrane, panel, position);
        panel.law = tensionOf(lawOf(system, membrane), strainOf(panel.axes) - panel.offset);
    }
    return energy();
}

// What the first corner has is minus what the two others have together, in each row and column.
TripleBlock ElasticPanels::block(const System& system, const ElasticPanel& panel) const
{
    const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
    const Vec3 pulling = pullingPart(panel.law.tension);
    const Mat3 tangent = tangentOf(lawOf(system, membrane), panel.law);
    const std::array<StrainPerMove, 2> perMove{StrainPerMove{gradient(membrane, 1)},
                                               StrainPerMove{gradient(membrane, 2)}};
    const auto between = [&](const StrainPerMove& one, const StrainPerMove& other) -> Mat3 {
        const Mat2 m = panel.weight * one.between(tangent, other);
        const double across = panel.weight
                              * (one.g[0] * (pulling[0] * other.g[0] + pulling[2] * other.g[1])
                                 + one.g[1] * (pulling[2] * other.g[0] + pulling[1] * other.g[1]));
        Mat3 sum =
            (m(0, 0) * panel.axes[0] + m(1, 0) * panel.axes[1]) * panel.axes[0].transpose()
            + (m(0, 1) * panel.axes[0] + m(1, 1) * panel.axes[1]) * panel.axes[1].transpose();
        sum.diagonal().array() += across;
        return sum;
    };
    TripleBlock block;
    block.corner[1] = between(perMove[0], perMove[0]);
    block.corner[2] = between(perMove[1], perMove[1]);
    block.pair[1] = between(perMove[0], perMove[1]);
    block.pair[0] = -(block.corner[1] + block.pair[1].transpose()); // of the first and the second
    block.pair[2] = -(block.corner[2] + block.pair[1].transpose()); // of the third and the first
    block.corner[0] = -(block.pair[0] + block.pair[2].transpose());
    for (std::size_t k = 0; k < 2; ++k)
        block.pull[k + 1] = -panel.weight * perMove[k].pull(panel.axes, panel.law.tension);
    block.pull[0] = -(block.pull[1] + block.pull[2]);
    return block;
}

void ElasticPanels::foresee(const System& system, std::span<const Row> move)
{
    for (ElasticPanel& panel : m_panels) {
        if (panel.gone)
            continue;
        panel.before = panel.law.tension;
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const Vec3 first = at(move[panel.row[0]]);
        Vec3 change = Vec3::Zero();
        for (int k = 1; k < 3; ++k)
            change += StrainPerMove{gradient(membrane, k)}.of(
                panel.axes, at(move[panel.row[std::size_t(k)]]) - first);
        panel.tension = panel.law.tension + tangentOf(lawOf(system, membrane), panel.law) * change;
    }
}

void ElasticPanels::settle(double share)
{
    for (ElasticPanel& panel : m_panels)
        if (!panel.gone)
            panel.tension = panel.before + share * (panel.tension - panel.before);
}

ElasticPanels::Account ElasticPanels::account(const System& system) const
{
    Account account;
    for (const ElasticPanel& panel : m_panels) {
        if (panel.gone)
            continue;
        const ClothLaw law = lawOf(system, system.membranes[std::size_t(panel.membrane)]);
        const auto energyOf = [&](const Vec3& tension) {
            return panel.weight * tension.dot(strainOf(law, tension));
        };
        account.pulls += energyOf(panel.tension);
        account.errors += energyOf(panel.law.tension - panel.tension);
    }
    return account;
}

double ElasticPanels::softness(const System& system, const ElasticPanel& panel, double h) const
{
    const ClothLaw law = lawOf(system, system.membranes[std::size_t(panel.membrane)]);
    const double stiffness = std::max(law.warp, law.weft); // N/m
    return stiffness > 0.0 ? 1.0 / (stiffness * h * h) : 0.0;
}

} // namespace ripstop
