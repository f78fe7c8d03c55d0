// Bending of the fabric and spars of a system, as far as it is a force.
//
// BendForce::list() describes a finished system as a network of panels and links and lets bendsOf()
// (base/bend.h) find the bends. prepare() sizes the arrays and notes, beside the rows of bends at
// each particle, with which weight the particle takes part in each. fill() goes over the bends
// twice: the turns come first and then the moments, as a moment needs the turns of the bends beside
// it; the sums at particles are the lane's. bendingEnergy() is the energy whose slope these forces
// are.
#include "forces/bend_force.h"

#include "base/key_index.h"
#include "forces/force.h"
#include "parallel/simd_pack.h"

#include <algorithm>

namespace ripstop {
namespace {

bool isGone(const System& system, const State& state, const Bend& bend)
{
    if (bend.ofSpar)
        return isTorn(system.links[std::size_t(bend.of[0])], state)
               || isTorn(system.links[std::size_t(bend.of[1])], state);
    return state.panelGone[std::size_t(bend.of[0])] || state.panelGone[std::size_t(bend.of[1])];
}

Vec3 sum(const Bend& bend, const std::vector<PaddedVec3>& x)
{
    Vec3 sum = bend.weight[0] * x[std::size_t(bend.corner[0])];
    for (std::size_t k = 1; k < 4; ++k)
        sum += bend.weight[k] * x[std::size_t(bend.corner[k])];
    return sum;
}

RIPSTOP_CLONES
void fillTurns(const System& system, const State& state, PaddedVec3* turn, std::size_t first,
               std::size_t last)
{
    const PaddedVec3* const x = state.position.data();
    const Bend* const bends = system.of<BendLists>().list.data();
    for (std::size_t i = first; i < last; ++i) {
        const Bend& bend = bends[i];
        if (isGone(system, state, bend)) {
            pack(turn[i]) = Pack{};
            continue;
        }
        Pack y = bend.weight[0] * pack(x[bend.corner[0]]);
        for (std::size_t k = 1; k < 4; ++k)
            y += bend.weight[k] * pack(x[bend.corner[k]]);
        pack(turn[i]) = y;
    }
}

// What the bend's own turn adds to its moment, N per m of the turn.
double ownMoment(const Bend& bend, const Vec3& turn)
{
    const double size = bend.restTurn > 0.0 ? turn.norm() : 0.0;
    return size > 0.0 ? bend.stiffness * (1.0 - bend.restTurn / size) : bend.stiffness;
}

RIPSTOP_CLONES
void fillMoments(const System& system, const State& state, const PaddedVec3* turn,
                 PaddedVec3* moment, std::size_t first, std::size_t last)
{
    const Bend* const bends = system.of<BendLists>().list.data();
    for (std::size_t i = first; i < last; ++i) {
        const Bend& bend = bends[i];
        if (isGone(system, state, bend)) {
            pack(moment[i]) = Pack{};
            continue;
        }
        Pack z = ownMoment(bend, turn[i]) * pack(turn[i]);
        if (!bend.ofSpar)
            for (std::size_t k = 0; k < 4; ++k)
                if (bend.beside[k] >= 0)
                    z += bend.coupling[k] * pack(turn[bend.beside[k]]);
        pack(moment[i]) = z;
    }
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
        net.links.push_back({link.a, link.b, length, material,
                             bending < 0 ? Bending() : system.bending[std::size_t(bending)],
                             link.kind == LinkKind::Rod});
    }
    return net;
}

class BendForce final : public Force
{
public:
    Message name() const override { return Message("bending"); }
    ForceKind kind() const override { return ForceKind::Elastic; }
    bool acts(const System& system, const State&) const override
    {
        return system.of<BendLists>().forces() > 0;
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
        return system.of<BendLists>().forces() > 0;
    }
    bool joinsRods(const System& system) const override
    {
        return !system.of<BendLists>().withRods().empty();
    }
    void addStiffness(const System& system, std::span<double> stiffness,
                      std::span<double>) const override;

private:
    std::vector<PaddedVec3> m_turn;   // [bends] m
    std::vector<PaddedVec3> m_moment; // [bends] N
    std::vector<double> m_weight;     // [items of the rows] 1, what the particle takes of a moment
    std::uint64_t m_serial = 0;       // of the values that m_weight is of
};

void BendForce::list(System& system) const
{
    BendLists& bends = system.of<BendLists>();
    bends.list.clear();
    bends.at.start.clear();
    bends.at.items.clear();
    if (system.bending.empty())
        return;
    bends.list = bendsOf(bendingNetOf(system));
    const std::span forces = std::span(bends.list).first(bends.forces());
    if (forces.empty())
        return;
    fillIncidence(bends.at, system.start.position.size(), forces, [](const Bend& bend) {
        return std::span(bend.corner).first(bend.ofSpar ? 3 : 4);
    });
}

void BendForce::prepare(const System& system, const State&)
{
    const auto& [bends, at] = system.of<BendLists>();
    m_turn.resize(countOfForces(bends));
    m_moment.resize(m_turn.size());
    if (m_serial == system.valuesSerial)
        return;
    m_serial = system.valuesSerial;
    m_weight.resize(at.items.size());
    for (std::size_t p = 0; p + 1 < at.start.size(); ++p)
        for (int k = at.start[p]; k < at.start[p + 1]; ++k) {
            const Bend& bend = bends[std::size_t(at.items[std::size_t(k)])];
            const auto corner = std::find(bend.corner.begin(), bend.corner.end(), int(p));
            m_weight[std::size_t(k)] = -bend.weight[std::size_t(corner - bend.corner.begin())];
        }
}

Lane BendForce::fill(const System& system, const State& state, ThreadPool& pool)
{
    fillBends(system, state, pool, m_turn, m_moment);
    return {.load = m_moment.data(), .at = &system.of<BendLists>().at, .weight = m_weight.data()};
}

void BendForce::addStiffness(const System& system, std::span<double> stiffness,
                             std::span<double>) const
{
    const std::vector<double> sums = bendSums(system.of<BendLists>().list, stiffness.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        stiffness[i] += sums[i];
}

} // namespace

void fillBends(const System& system, const State& state, ThreadPool& pool,
               std::span<PaddedVec3> turn, std::span<PaddedVec3> moment)
{
    const std::size_t count = turn.size();
    pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
        fillTurns(system, state, turn.data(), first, last);
    });
    pool.parallelFor(count, [&](std::size_t first, std::size_t last) {
        fillMoments(system, state, turn.data(), moment.data(), first, last);
    });
}

double bendingEnergy(const System& system, const State& state)
{
    const auto turnOf = [&](const Bend& bend) {
        return isGone(system, state, bend) ? Vec3(Vec3::Zero()) : Vec3(sum(bend, state.position));
    };
    double energy = 0.0;
    for (const Bend& bend : system.of<BendLists>().list) {
        if (isGone(system, state, bend))
            continue;
        const Vec3 turn = turnOf(bend);
        const double own = turn.norm() - bend.restTurn;
        energy += 0.5 * bend.stiffness * own * own;
        for (std::size_t k = 0; k < 4; ++k)
            if (bend.beside[k] >= 0)
                energy +=
                    0.5 * bend.coupling[k]
                    * turn.dot(turnOf(system.of<BendLists>().list[std::size_t(bend.beside[k])]));
    }
    return energy;
}

std::unique_ptr<Force> BendLists::makeForce() { return std::make_unique<BendForce>(); }

} // namespace ripstop
