// Each panel is looked at by itself, in the order of System::membranes or of rows; sums are added
// in that order. Gradients of the corners are the rows of the inverse of the panel's shape, that of
// the first corner being minus the sum of the others.
#include "constraints/elastic_panels.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// How the strain changes as a corner moves, 1/m: a row for each component.
Mat3 strainPerMove(const ClothAxes& axes, const std::array<double, 2>& g)
{
    Mat3 rows;
    rows.row(0) = g[0] * axes[0].transpose();
    rows.row(1) = g[1] * axes[1].transpose();
    rows.row(2) = g[1] * axes[0].transpose() + g[0] * axes[1].transpose();
    return rows;
}

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
        const ClothLaw& law = lawOf(system, membrane);
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

double ElasticPanels::measure(const System& system, std::span<const Row> position)
{
    for (ElasticPanel& panel : m_panels) {
        if (panel.gone)
            continue;
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        const Vec3 a = at(position[panel.row[0]]);
        panel.axes =
            axesOf(membrane, at(position[panel.row[1]]) - a, at(position[panel.row[2]]) - a);
        panel.law = tensionOf(lawOf(system, membrane), strainOf(panel.axes) - panel.offset);
    }
    return energy();
}

TripleBlock ElasticPanels::block(const System& system, const ElasticPanel& panel) const
{
    const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
    const Vec3 pulling = pullingPart(panel.law.tension);
    std::array<Mat3, 3> perMove, pullPerMove;
    std::array<std::array<double, 2>, 3> g;
    TripleBlock block;
    const Mat3 tangent = tangentOf(lawOf(system, membrane), panel.law);
    for (std::size_t k = 0; k < 3; ++k) {
        g[k] = gradient(membrane, int(k));
        perMove[k] = strainPerMove(panel.axes, g[k]);
        pullPerMove[k] = panel.weight * (tangent * perMove[k]);
        block.pull[k] = -panel.weight * (perMove[k].transpose() * panel.law.tension);
    }
    const auto across = [&](std::size_t i, std::size_t j) {
        return panel.weight
               * (g[i][0] * (pulling[0] * g[j][0] + pulling[2] * g[j][1])
                  + g[i][1] * (pulling[2] * g[j][0] + pulling[1] * g[j][1]));
    };
    const auto between = [&](std::size_t i, std::size_t j) -> Mat3 {
        return perMove[i].transpose() * pullPerMove[j] + across(i, j) * Mat3::Identity();
    };
    for (std::size_t k = 0; k < 3; ++k) {
        block.corner[k] = between(k, k);
        block.pair[k] = between(sidesOfTriple[k].first, sidesOfTriple[k].second);
    }
    return block;
}

void ElasticPanels::foresee(const System& system, std::span<const Row> move)
{
    for (ElasticPanel& panel : m_panels) {
        if (panel.gone)
            continue;
        panel.before = panel.law.tension;
        const Membrane& membrane = system.membranes[std::size_t(panel.membrane)];
        Vec3 change = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            change +=
                strainPerMove(panel.axes, gradient(membrane, int(k))) * at(move[panel.row[k]]);
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
        const ClothLaw& law = lawOf(system, system.membranes[std::size_t(panel.membrane)]);
        const auto energyOf = [&](const Vec3& tension) {
            return panel.weight * tension.dot(strainOf(law, tension));
        };
        account.pulls += energyOf(panel.tension);
        account.errors += energyOf(panel.law.tension - panel.tension);
    }
    return account;
}

} // namespace ripstop
