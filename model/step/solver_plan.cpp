// planFor() gives rods to the global solve for five reasons: spars that bend; rods of real
// stiffness, whose pulls sweeps would need too many substeps for (substepsForPull); networks that
// are cheap to factorise, whatever their load; heavy loads on lines, of which worstRod() finds the
// rod that needs most substeps, from the load that it estimates by the mass that Networks sums,
// joined by rods without passing a pin or a guide; and whatever else would need far too many. The
// worst rod that is left then decides the substeps, at least as many as the stiffness of the forces
// needs. Planner notes the reasons.
//
// While the system runs, adaptedSubsteps() follows the error that is measured.
#include "step/solver_plan.h"

#include "base/joined_sets.h"
#include "base/portable_math.h"
#include "constraints/direct_choice.h"
#include "forces/forces.h"
#include "laws/step_limit.h"
#include "step/branches.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace ripstop {
namespace {

constexpr double safety = 1.5;
constexpr double spareForTurning = 0.6;   // kites of 10 ms a substep flutter above about 0.4
constexpr double manySubsteps = 100.0;    // in 10 ms
constexpr double tooManySubsteps = 300.0; // in 10 ms, of any network
constexpr double manyForPull = 40.0;
constexpr double farLighter = 1000.0;
constexpr std::size_t mostRigid = 50000;     // particles; more take too much memory
constexpr std::size_t mostForBlocks = 20000; // particles; looking for blocks takes its time

// What rods join, without passing a pin or a guide.
class Networks
{
public:
    explicit Networks(const System& system)
        : m_sets(system.inverseMass.size())
        , m_mass(system.inverseMass.size(), 0.0)
        , m_rodsAtPins(system.inverseMass.size(), 0)
    {
        const auto pinned = [&](int p) { return bears(system, p); };
        for (const Rod& rod : system.rods)
            if (!pinned(rod.a) && !pinned(rod.b))
                m_sets.join(rod.a, rod.b);
        for (std::size_t p = 0; p < m_mass.size(); ++p)
            if (!pinned(int(p)))
                m_mass[std::size_t(m_sets.of(int(p)))] += 1.0 / system.inverseMass[p];
        for (const Rod& rod : system.rods)
            if (pinned(rod.a) != pinned(rod.b))
                ++m_rodsAtPins[std::size_t(m_sets.of(pinned(rod.a) ? rod.b : rod.a))];
    }

    int of(int p) { return m_sets.of(p); } // a particle that stands for its network
    double mass(int p) { return m_mass[std::size_t(m_sets.of(p))]; } // kg
    int rodsAtPins(int p) { return m_rodsAtPins[std::size_t(m_sets.of(p))]; }

private:
    JoinedSets m_sets;
    std::vector<double> m_mass;
    std::vector<int> m_rodsAtPins;
};

struct Worst
{
    double substeps = 1.0;
    int rod = -1;
    bool hangsHeavy = false; // a network that is pinned holds a load by particles far lighter
};

// The rod that needs most substeps, of those that are not in `direct`.
Worst worstRod(const System& system, const std::vector<std::uint8_t>& direct)
{
    Networks networks(system);
    const double pull = 2.0 * loadingGravity(system);
    const auto loadAt = [&](int p, int other) {
        const double w = system.inverseMass[std::size_t(p)];
        const bool holds = bears(system, p);
        const double held = pull * networks.mass(other) / std::max(networks.rodsAtPins(other), 1);
        if (w == 0.0)
            return held;
        const int rods =
            system.rodsAt.start[std::size_t(p) + 1] - system.rodsAt.start[std::size_t(p)];
        const double mass = 1.0 / w;
        if (holds)
            return std::max(held, pull * mass / rods);
        const bool hangs = networks.rodsAtPins(p) > 0; // what is pinned takes any pull
        return pull * (hangs ? mass : std::min(mass, networks.mass(p) - mass)) / rods;
    };
    Worst worst;
    for (std::size_t r = 0; r < system.rods.size(); ++r) {
        const Rod& rod = system.rods[r];
        const double u = system.inverseMass[std::size_t(rod.a)];
        const double w = system.inverseMass[std::size_t(rod.b)];
        const double weight = u + w;
        if ((!direct.empty() && direct[r]) || weight == 0.0 || rod.restLength <= 0.0
            || rod.compliance > 0.0)
            continue;
        if (u > 0.0 && w > 0.0 && networks.rodsAtPins(rod.a) > 0)
            worst.hangsHeavy |= std::max(u, w) > farLighter * std::min(u, w);
        const double load = std::max(loadAt(rod.a, rod.b), loadAt(rod.b, rod.a));
        const double substeps = safety * system.timeStep
                                * std::sqrt(load * weight / (system.strainGoal * rod.restLength));
        if (substeps > worst.substeps) {
            worst.substeps = substeps;
            worst.rod = int(r);
        }
    }
    return worst;
}

// Substeps that a rod of some compliance needs for its pull.
double substepsForPull(const System& system, const Rod& rod)
{
    const double weight =
        system.inverseMass[std::size_t(rod.a)] + system.inverseMass[std::size_t(rod.b)];
    return system.timeStep * std::sqrt(weight / (rod.compliance * system.accuracy));
}

// Of the rods with compliance that are not in `direct`.
double substepsForPulls(const System& system, const std::vector<std::uint8_t>& direct)
{
    double most = 1.0;
    for (std::size_t r = 0; r < system.rods.size(); ++r)
        if (system.rods[r].compliance > 0.0 && (direct.empty() || !direct[r]))
            most = std::max(most, substepsForPull(system, system.rods[r]));
    return most;
}

int substepsWithin(double timeStep, double limit, double spare)
{
    return std::clamp(int(std::ceil(std::min(spare * timeStep / limit, double(mostSubsteps)))), 1,
                      mostSubsteps);
}

// [rods] 1 where it is of a spar whose bends are solved with its rods.
std::vector<std::uint8_t> rodsThatBend(const System& system)
{
    std::vector<std::uint8_t> result(system.rods.size(), 0);
    for (const Bend& bend : system.of<BendLists>().withRods())
        for (const int link : bend.of)
            result[std::size_t(system.links[std::size_t(link)].index)] = 1;
    return result;
}

bool moves(const System& system, const Rod& rod)
{
    return system.inverseMass[std::size_t(rod.a)] > 0.0
           || system.inverseMass[std::size_t(rod.b)] > 0.0;
}

bool isDamped(const Rod& rod) { return rod.compliance > 0.0 && rod.dampingTime > 0.0; }

// Whether what the solver makes of rods that never stretch is so stiff that it does not ring:
// nothing that they hold swings on them by less than a radian in a substep, of which BDF2 leaves
// 93 % in each. Along branches, 1 / w^2 of the slowest such swing is at most the sum of what each
// rod gives way by under a unit of force times the mass beyond it (Dunkerley 1894); rods that close
// loops only make it faster.
bool rigidRodsHoldStill(const System& system)
{
    constexpr double enough = 1.0; // (1 / w h)^2
    std::map<int, double> sums;    // of each tree
    for (const Branch& branch : branchesOf(system)) {
        if (branch.rod == noRod)
            continue;
        const Rod& rod = system.rods[std::size_t(branch.rod)];
        const double weight =
            system.inverseMass[std::size_t(rod.a)] + system.inverseMass[std::size_t(rod.b)];
        if (rod.compliance == 0.0)
            sums[branch.tree] += greatestSoftness * weight * branch.massBeyond;
    }
    return std::ranges::all_of(sums, [](const auto& sum) { return sum.second < enough; });
}

// Whether rods without damping close no loop, which one from what bears to what bears does, too:
// pendulums, lines and spars that are held by one end can swing, but nothing of them is so tight
// that it rings.
bool undampedRodsAreBranches(const System& system)
{
    const int ground = int(system.inverseMass.size()); // all that bears is one
    JoinedSets sets(system.inverseMass.size() + 1);
    const auto nodeOf = [&](int p) { return bears(system, p) ? ground : p; };
    return std::ranges::all_of(system.rods, [&](const Rod& rod) {
        const int a = nodeOf(rod.a), b = nodeOf(rod.b);
        if (isDamped(rod) || (a == ground && b == ground))
            return true;
        const bool closes = sets.of(a) == sets.of(b);
        sets.join(a, b);
        return !closes;
    });
}

bool rodsAreDamped(const System& system)
{
    return std::ranges::all_of(
        system.rods, [&](const Rod& rod) { return isDamped(rod) || !moves(system, rod); });
}

bool panelsAreDamped(const System& system)
{
    return std::ranges::all_of(system.membranes, [&](const Membrane& membrane) {
        const auto panel = std::size_t(membrane.panel);
        const auto air = std::size_t(system.panels[panel].air);
        const ClothLaw& law = system.cloth[air];
        return !law.isElastic() || law.dampingTime > 0.0;
    });
}

// Makes a plan by giving rods away to the global solve, for one reason after the other.
class Planner
{
public:
    explicit Planner(const System& system)
        : m_system(system)
        , m_direct(system.rods.size(), 0)
        , m_limit(stiffStepLimit(system))
        , m_stiff(substepsWithin(system.timeStep, m_limit, spareOfSubsteps))
    {}

    // Returns whether there were any that had not been given before.
    //   why  says it, given the number of rods and the sentence that follows
    using Why = std::function<Message(std::size_t, const Message&)>;
    bool give(const std::vector<int>& rods, Why why)
    {
        std::size_t count = 0;
        for (const int rod : rods)
            count += !std::exchange(m_direct[std::size_t(rod)], std::uint8_t(1));
        if (count > 0)
            m_given.push_back({count, std::move(why)});
        return count > 0;
    }

    // All rods of networks that have one like this, of those that are not given yet.
    template <typename IsOne> // isOne(rod)
    std::vector<int> networksOf(IsOne isOne) const
    {
        return rodsOfNetworks(m_system, [&](const Rod& rod) {
            return !m_direct[std::size_t(&rod - m_system.rods.data())] && isOne(rod);
        });
    }

    const std::vector<std::uint8_t>& direct() const { return m_direct; }

    SolverPlan plan(double substeps) const
    {
        SolverPlan plan;
        plan.together = givesAll();
        plan.integrator = integratorOf(plan.together);
        plan.least = leastOf(plan.integrator);
        plan.substeps =
            std::max(int(std::ceil(std::min(substeps, double(mostSubsteps)))), plan.least);
        if (!m_given.empty())
            plan.direct = m_direct;
        if (!m_system.membranes.empty())
            plan.reason =
                Message("%1 panels carry the pull of the fabric and are solved together "
                        "with all rods; %2",
                        m_system.membranes.size(), substepsBy(plan.integrator, plan.substeps));
        else if (m_system.rods.empty())
            plan.reason = Message("there are no rods");
        else if (!m_given.empty() && substeps <= 1.0)
            plan.reason = substepsBy(plan.integrator, plan.substeps);
        else
            plan.reason =
                Message("small steps: %1 substeps of one sweep to begin with, for a "
                        "strain of %2 %",
                        plan.substeps, Message::number("%.3g", 100.0 * m_system.strainGoal));
        if (m_stiff > 1)
            plan.reason = needs(std::move(plan.reason), plan.substeps);
        if (!m_system.membranes.empty())
            return plan;
        for (auto given = m_given.rbegin(); given != m_given.rend(); ++given)
            plan.reason = given->why(given->count, plan.reason);
        return plan;
    }

private:
    //   taken  substeps, of which the author may want more than the solver takes by itself
    Message needs(Message reason, int taken) const
    {
        const double wanted = std::ceil(spareOfSubsteps * m_system.timeStep / m_limit);
        if (wanted > taken)
            return Message("%1; %2 would need %3, and no more are taken", std::move(reason),
                           boundingForces(m_system), Message::number("%.3g", wanted));
        return Message("%1; %2 needs at least %3", std::move(reason), boundingForces(m_system),
                       int(wanted));
    }

    bool givesAll() const
    {
        for (std::size_t r = 0; r < m_direct.size(); ++r)
            if (moves(m_system, m_system.rods[r]) && !m_direct[r])
                return false;
        return !m_given.empty() || !m_system.membranes.empty();
    }

    // BDF2 where what bends is slow enough for it in half as many substeps as Euler's method takes:
    // it may look at its loads twice in each.
    Integrator integratorOf(bool together) const
    {
        if (m_system.integrator != Integrator::Auto)
            return m_system.integrator;
        const int ofEuler = leastOf(Integrator::SemiImplicitEuler);
        const bool isCalm = panelsAreDamped(m_system) && undampedRodsAreBranches(m_system)
                            && rigidRodsHoldStill(m_system)
                            && std::max(1, ofEuler / 2) * m_limit >= slowBends * m_system.timeStep;
        return together && isCalm ? Integrator::Bdf2 : Integrator::SemiImplicitEuler;
    }

    // Substeps that the author asks for, and what forces need.
    int leastOf(Integrator integrator) const
    {
        const int wanted = std::max(m_stiff, wantedOf(integrator));
        if (integrator != Integrator::Bdf2 || m_system.integrator != Integrator::Auto)
            return wanted;
        return std::max(wanted, substepsWithin(m_system.timeStep, m_limit, slowBends));
    }

    // Substeps that the author wants at least.
    int wantedOf(Integrator integrator) const
    {
        if (integrator != Integrator::Bdf2 || m_system.integrator != Integrator::Auto)
            return m_system.substeps;
        const int times = rodsAreDamped(m_system) ? substepsOfEuler : substepsOfEuler / 2;
        return (m_system.substeps + times - 1) / times;
    }

    static Message substepsBy(Integrator integrator, int substeps)
    {
        if (integrator != Integrator::Bdf2)
            return Message("%1 substeps", substeps);
        return substeps == 1 ? Message("1 substep of bdf2")
                             : Message("%1 substeps of bdf2", substeps);
    }

    struct Given
    {
        std::size_t count; // of rods
        Why why;
    };

    const System& m_system;
    std::vector<std::uint8_t> m_direct; // [rods]
    double m_limit;                     // s, of a substep, that forces set
    int m_stiff;                        // substeps that they need
    std::vector<Given> m_given;
};

} // namespace

SolverPlan planFor(const System& system)
{
    Planner planner(system);
    const auto isAny = [](const Rod&) { return true; };
    if (!system.membranes.empty())
        planner.give(planner.networksOf(isAny), nullptr);
    if (system.rods.empty() || !system.membranes.empty())
        return planner.plan(1.0);
    const double many = manySubsteps * system.timeStep / 0.01;
    const double tooMany = tooManySubsteps * system.timeStep / 0.01;
    const bool mayHaveBlocks = system.inverseMass.size() <= mostForBlocks;

    if (isImplicit(system.integrator))
        planner.give(planner.networksOf(isAny), [&](std::size_t count, const Message& rest) {
            return Message("%1 rods are solved together, as %2 needs it; %3", count,
                           Message::word(choiceNames<Integrator>[std::size_t(system.integrator)]),
                           rest);
        });
    if (system.springsAsRods > 0)
        planner.give(planner.networksOf(isAny), [&](std::size_t count, const Message& rest) {
            return Message("%1 links, springs among them that are too stiff for the substep, are "
                           "solved together; %2",
                           count, rest);
        });
    const std::vector<std::uint8_t> bends = rodsThatBend(system);
    const auto isOfSpar = [&](const Rod& rod) {
        return bends[std::size_t(&rod - system.rods.data())] != 0;
    };
    planner.give(planner.networksOf(isOfSpar), [](std::size_t count, const Message& rest) {
        return Message("%1 rods are solved together, since spars among them bend; %2", count, rest);
    });
    const auto isTooStiff = [&](const Rod& rod) {
        return rod.compliance > 0.0 && substepsForPull(system, rod) > manyForPull;
    };
    planner.give(planner.networksOf(isTooStiff), [](std::size_t count, const Message& rest) {
        return Message("%1 rods are solved together, since they are too stiff for sweeps; %2",
                       count, rest);
    });
    if (mayHaveBlocks)
        planner.give(rodsOfCheapNetworks(system), [](std::size_t count, const Message& rest) {
            return Message("%1 rods are solved directly, which costs little for what they join; "
                           "%2",
                           count, rest);
        });
    if (system.airDensity > 0.0 && system.inverseMass.size() <= mostRigid)
        planner.give(rodsOfFlyingFabric(system), [](std::size_t count, const Message& rest) {
            return Message("%1 rods are solved together, since the air loads their fabric by more "
                           "than sweeps hold; %2",
                           count, rest);
        });
    Worst worst = worstRod(system, planner.direct());
    // A heavy load on light lines stretches them little in a step, but the sweeps give back more
    // than they took: it bounces higher and higher.
    const auto ofLoad = [needed = worst.substeps, many](std::size_t count, const Message& rest) {
        return needed > many
                   ? Message("%1 rods are solved directly, since their load would need %2 "
                             "substeps; %3",
                             count, Message::number("%.0f", needed), rest)
                   : Message("%1 rods are solved directly, since their load is far heavier than "
                             "what holds it; %2",
                             count, rest);
    };
    if ((worst.substeps > many || worst.hangsHeavy) && mayHaveBlocks
        && planner.give(rodsForDirect(system), ofLoad))
        worst = worstRod(system, planner.direct());
    // What is left may be too much for sweeps as well, and too large for a block.
    const auto isRigid = [](const Rod& rod) { return rod.compliance == 0.0; };
    const auto ofSize = [needed = worst.substeps](std::size_t count, const Message& rest) {
        return Message("%1 rods are solved together, since sweeps would need %2 substeps; %3",
                       count, Message::number("%.0f", needed), rest);
    };
    if (worst.substeps > tooMany && system.inverseMass.size() <= mostRigid
        && planner.give(planner.networksOf(isRigid), ofSize))
        worst = worstRod(system, planner.direct());
    return planner.plan(std::max(worst.substeps, substepsForPulls(system, planner.direct())));
}

int substepsForDamping(const System& system, const State& state, bool joinsMasses, Damping& scratch)
{
    return substepsWithin(system.timeStep, dampingStepLimit(system, state, scratch),
                          joinsMasses ? spareForTurning : 1.5);
}

// The strain falls with about the 1.5th power of the number of substeps.
int adaptedSubsteps(int substeps, int least, double ratio)
{
    double next = substeps;
    if (ratio > 1.0)
        next = std::max(
            substeps + 1.0,
            std::ceil(substeps * (ratio < 2.8 ? portableExp(portableLog(ratio) / 1.5) : 2.0)));
    else if (ratio < 0.4)
        next = std::floor(substeps * 0.9);
    return int(std::clamp(next, double(least), double(std::max(mostSubsteps, least))));
}

} // namespace ripstop
