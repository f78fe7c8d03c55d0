// Bending of the fabric and spars of a system, as far as it is a force.
//
// BendForce::list() describes a finished system as a network of panels and links and lets
// bendsAndPanelsOf() (laws/bend.h) find the bends, and says which of them the solver takes. The
// rest pull in one lane: panels first (laws/fabric_bending.h), then spars.
#include "forces/bend_force.h"

#include "base/key_index.h"
#include "forces/force.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace ripstop {
namespace {

// Of the spar `i` that is a force.
void fillLoads(const System& system, const State& state, BendScratch& bends, std::size_t i)
{
    const BendLists& lists = system.of<BendLists>();
    std::ranges::copy(pullsOfSpar(system, state, lists.spars()[i]),
                      &bends.load[3 * (lists.pullingPanels().size() + i)]);
}

struct AllOfFabric // also what is solved together with other panels
{
    FabricBending bending;
    std::vector<PaddedVec3> load; // [panels] N, three of each
};

AllOfFabric ofFabric(const System& system, const State& state)
{
    const std::vector<BentPanel>& panels = system.of<BendLists>().panels;
    AllOfFabric all;
    all.bending.size(panels.size());
    all.load.resize(3 * panels.size());
    ThreadPool alone(1);
    all.bending.fill(panels, state.panelGone, state.position.data(), all.load.data(), alone);
    return all;
}

BendingNet bendingNetOf(const System& system)
{
    BendingNet net;
    net.solvesTogether = solvesTogether(system.solver);
    for (std::size_t i = 0; i < system.start.position.size(); ++i) {
        net.position.push_back(system.start.position[i]);
        net.pinned.push_back(system.inverseMass[i] == 0.0);
    }
    for (const FabricPanel& panel : system.panels)
        net.panels.push_back({panel.corner, system.bending[std::size_t(panel.air)]});
    KeyIndex bendingOf(system.materialAir.size());
    for (std::size_t i = 0; i < system.materialAir.size(); ++i)
        bendingOf.add(system.materialAir[i].key, int(i));
    for (std::size_t i = 0; i < system.links.size(); ++i) {
        const LinkPlace& link = system.links[i];
        const auto index = std::size_t(link.index);
        const double length = link.kind == LinkKind::Spring ? system.springs[index].restLength
                                                            : system.rods[index].restLength;
        const Key material = system.linkStuff.empty() ? 0 : system.linkStuff[i].material;
        const int bending = system.linkStuff.empty() ? -1 : bendingOf(material);
        Bending own = bending < 0 ? Bending() : system.bending[std::size_t(bending)];
        own.breaking *= system.factorsOf(i).strength;
        net.links.push_back({link.a, link.b, length, material, own, link.kind == LinkKind::Rod});
    }
    return net;
}

std::vector<std::uint8_t> panelsThatCarry(const System& system)
{
    std::vector<std::uint8_t> carries(system.panels.size(), 0);
    for (const Membrane& membrane : system.membranes)
        carries[std::size_t(membrane.panel)] = 1;
    return carries;
}

std::vector<double> massesOf(const System& system) // kg, 0 of what is pinned
{
    std::vector<double> mass;
    for (const double w : system.inverseMass)
        mass.push_back(w > 0.0 ? 1.0 / w : 0.0);
    return mass;
}

class BendForce final : public Force
{
public:
    Message name() const override { return Message("bending"); }
    ForceKind kind() const override { return ForceKind::Elastic; }
    bool acts(const System& system, const State&) const override
    {
        return system.of<BendLists>().arePulling();
    }
    bool hangsOn(const Edited& e) const override
    {
        return e.materials || e.particles || e.links || e.linkStuff || e.panels || e.solver;
    }
    void list(System& system) const override;
    void prepare(const System& system, const State&) override;
    Lane fill(const System& system, const State& state, ThreadPool& pool) override;
    double energy(const System& system, const State& state) const override
    {
        return bendingEnergy(system, state);
    }
    bool boundsSubstep(const System& system) const override
    {
        return system.of<BendLists>().arePulling();
    }
    bool joinsRods(const System& system) const override
    {
        const BendLists& bends = system.of<BendLists>();
        return !bends.withRods().empty() || !bends.solvedPanels().empty();
    }
    void addStiffness(const System& system, std::span<double> stiffness,
                      std::span<double>) const override;

private:
    BendScratch m_bends;
};

void BendForce::list(System& system) const
{
    BendLists& bends = system.of<BendLists>();
    bends = {};
    if (system.bending.empty())
        return;
    BendsAndPanels found = bendsAndPanelsOf(bendingNetOf(system));
    bends.panelsAreSolved =
        system.solver == Solver::Auto
        && isSolvedWithPull(found, panelsThatCarry(system), massesOf(system), system.timeStep);
    bends.list = std::move(found.bends);
    bends.panels = std::move(found.panels);
    if (!bends.arePulling())
        return;
    std::vector<int> corners; // particles
    for (const BentPanel& panel : bends.pullingPanels())
        corners.insert(corners.end(), panel.corner.begin(), panel.corner.end());
    for (const Bend& bend : bends.spars())
        corners.insert(corners.end(), bend.corner.begin(), bend.corner.begin() + 3);
    fillIncidence(bends.at, system.start.position.size(), corners,
                  [](const int& corner) { return std::span(&corner, 1); });
}

void BendForce::prepare(const System& system, const State&)
{
    m_bends.size(system.of<BendLists>());
}

Lane BendForce::fill(const System& system, const State& state, ThreadPool& pool)
{
    fillBends(system, state, pool, m_bends);
    return {.load = m_bends.load.data(), .at = &system.of<BendLists>().at};
}

void BendForce::addStiffness(const System& system, std::span<double> stiffness,
                             std::span<double>) const
{
    const std::vector<double> sums = bendSums(system.of<BendLists>().forces(), stiffness.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        stiffness[i] += sums[i];
}

} // namespace

void BendScratch::size(const BendLists& bends)
{
    fabric.size(bends.pullingPanels().size());
    load.resize(3 * (bends.pullingPanels().size() + bends.spars().size()));
}

std::array<Vec3, 2> waysOf(const Bend& spar, const State& state)
{
    const Vec3& at = state.position[std::size_t(spar.corner[0])];
    return {Vec3(state.position[std::size_t(spar.corner[1])] - at),
            Vec3(state.position[std::size_t(spar.corner[2])] - at)};
}

bool isCut(const System& system, const State& state, const Bend& spar)
{
    return isTorn(system.links[std::size_t(spar.of[0])], state)
           || isTorn(system.links[std::size_t(spar.of[1])], state);
}

std::array<Vec3, 3> pullsOfSpar(const System& system, const State& state, const Bend& spar)
{
    if (isCut(system, state, spar))
        return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    const SparTurn at = turnOf(spar, waysOf(spar, state));
    const double size = spar.restTurn > 0.0 ? at.turn.norm() : 0.0;
    const double left = size > 0.0 ? 1.0 - spar.restTurn / size : 1.0;
    const Vec3 moment = spar.stiffness * left * at.turn;
    const Vec3 first = -at.slope[0] * moment, second = -at.slope[1] * moment;
    return {-(first + second), first, second};
}

double bendingMoment(const System& system, const State& state, const Bend& spar)
{
    return isCut(system, state, spar) ? 0.0 : momentOf(spar, waysOf(spar, state));
}

void fillBends(const System& system, const State& state, ThreadPool& pool, BendScratch& bends)
{
    const BendLists& lists = system.of<BendLists>();
    bends.fabric.fill(lists.pullingPanels(), state.panelGone, state.position.data(),
                      bends.load.data(), pool);
    pool.parallelFor(lists.spars().size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            fillLoads(system, state, bends, i);
    });
}

double bendingEnergy(const System& system, const State& state)
{
    const BendLists& lists = system.of<BendLists>();
    double energy = ofFabric(system, state).bending.energy(lists.panels);
    for (const Bend& bend : lists.ofSpars()) {
        if (isCut(system, state, bend))
            continue;
        energy += energyOf(bend, waysOf(bend, state));
    }
    return energy;
}

std::vector<Vec3> pullsOfBends(const System& system, const State& state)
{
    const BendLists& lists = system.of<BendLists>();
    std::vector<Vec3> pulls(state.position.size(), Vec3::Zero());
    const auto add = [&](const auto& corner, const auto* load) {
        for (std::size_t k = 0; k < 3; ++k)
            pulls[std::size_t(corner[k])] += load[k];
    };
    const std::vector<PaddedVec3> loads = ofFabric(system, state).load;
    const PaddedVec3* load = loads.data();
    for (const BentPanel& panel : lists.panels) {
        add(panel.corner, load);
        load += 3;
    }
    for (const Bend& spar : lists.ofSpars())
        add(spar.corner, pullsOfSpar(system, state, spar).data());
    return pulls;
}

std::unique_ptr<Force> BendLists::makeForce() { return std::make_unique<BendForce>(); }

} // namespace ripstop
