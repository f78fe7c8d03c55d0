// planFor() gives rods to direct blocks for three reasons, in systems of at most 20 000 particles.
// Rods of small fabric come first, whatever their load. Of the rest, worstRod() finds the rod that
// needs most substeps, from the load that it estimates by the mass that Networks sums, joined by
// rods without passing a pin or a guide. rodsForDirect() is asked when that number is too large, or
// when a pinned network holds a heavy load by particles that are far lighter, since sweeps would
// make the load bounce. The worst rod that is left then decides the substeps, at least as many as
// the stiffness of the forces needs, and the plan states its reason.
//
// While the system runs, adaptedSubsteps() follows the strain that is measured.
#include "step/solver_plan.h"

#include "base/joined_sets.h"
#include "base/portable_math.h"
#include "constraints/direct_choice.h"
#include "constraints/guides.h"
#include "forces/forces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

constexpr int mostSubsteps = 2000;
constexpr double safety = 1.5;
constexpr double leastGravity = 9.80665; // m/s^2; wind loads what floats in space too
constexpr double manySubsteps = 100.0;   // in 10 ms
constexpr double manyForPull = 40.0;
constexpr double farLighter = 1000.0;
constexpr std::size_t mostForBlocks = 20000; // particles; looking for blocks takes its time

// Pinned, or on a guide, which bears a load as a pin does.
bool bears(const System& system, int p)
{
    return system.inverseMass[std::size_t(p)] == 0.0 || guideOf(system, p);
}

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
    const double pull = 2.0 * std::max(system.gravity.norm(), leastGravity);
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

// A twentieth to spare.
int substepsForStiffness(const System& system)
{
    return substepsWithin(system.timeStep, stiffStepLimit(system), 1.05);
}

} // namespace

SolverPlan planFor(const System& system)
{
    SolverPlan plan;
    plan.least = substepsForStiffness(system);
    plan.substeps = std::max(system.substeps, plan.least);
    const auto bounded = [&](Message reason) {
        return plan.least > 1 ? Message("%1; %2 needs at least %3", std::move(reason),
                                        boundingForces(system), plan.least)
                              : reason;
    };
    if (system.rods.empty()) {
        plan.reason = bounded(Message("there are no rods"));
        return plan;
    }
    const std::vector<int> stiff = rodsOfNetworks(system, [&](const Rod& rod) {
        return rod.compliance > 0.0 && substepsForPull(system, rod) > manyForPull;
    });
    const bool mayHaveBlocks = system.inverseMass.size() <= mostForBlocks;
    const auto solveDirectly = [&](const std::vector<int>& rods) {
        plan.direct.resize(system.rods.size(), 0);
        std::size_t more = 0;
        for (const int rod : rods)
            more += !std::exchange(plan.direct[std::size_t(rod)], std::uint8_t(1));
        return more;
    };
    std::size_t ofStiff = 0, ofFabric = 0, ofLoad = 0; // rods that are solved together
    if (!stiff.empty())
        ofStiff = solveDirectly(stiff);
    if (mayHaveBlocks)
        if (const std::vector<int> rods = rodsOfSmallFabric(system); !rods.empty())
            ofFabric = solveDirectly(rods);
    Worst worst = worstRod(system, plan.direct);
    const double many = manySubsteps * system.timeStep / 0.01;
    double ofSweeps = 0.0; // substeps that the load would need
    // A heavy load on light lines stretches them little in a step, but the sweeps give back more
    // than they took: it bounces higher and higher.
    if ((worst.substeps > many || worst.hangsHeavy) && mayHaveBlocks)
        if (const std::vector<int> rods = rodsForDirect(system); !rods.empty()) {
            ofLoad = solveDirectly(rods);
            ofSweeps = worst.substeps;
            worst = worstRod(system, plan.direct);
        }
    const double forPulls = substepsForPulls(system, plan.direct);
    plan.substeps =
        std::max(int(std::ceil(std::min(std::max(worst.substeps, forPulls), double(mostSubsteps)))),
                 plan.substeps);
    const bool all = !plan.direct.empty()
                     && std::ranges::all_of(plan.direct, [](std::uint8_t one) { return one; });
    if (all)
        plan.reason = bounded(Message("%1 substeps", plan.substeps));
    else
        plan.reason =
            bounded(Message("small steps: %1 substeps of one sweep to begin with, for a "
                            "strain of %2 %",
                            plan.substeps, Message::number("%.3g", 100.0 * system.strainGoal)));
    if (ofLoad > 0)
        plan.reason =
            ofSweeps > many
                ? Message("%1 rods are solved directly, since their load would need %2 substeps; "
                          "%3",
                          ofLoad, Message::number("%.0f", ofSweeps), plan.reason)
                : Message("%1 rods are solved directly, since their load is far heavier than what "
                          "holds it; %2",
                          ofLoad, plan.reason);
    if (ofFabric > 0)
        plan.reason = Message("%1 rods are solved directly, since they hold fabric that is small "
                              "enough for it; %2",
                              ofFabric, plan.reason);
    if (ofStiff > 0)
        plan.reason = Message("%1 rods are solved together, since they are too stiff for sweeps; "
                              "%2",
                              ofStiff, plan.reason);
    return plan;
}

int substepsForDamping(const System& system, const State& state, std::vector<double>& scratch)
{
    return substepsWithin(system.timeStep, dampingStepLimit(system, state, scratch), 1.5);
}

// The strain falls with about the 1.5th power of the number of substeps.
int adaptedSubsteps(const System& system, int substeps, double ratio)
{
    double next = substeps;
    if (ratio > 1.0)
        next = std::max(
            substeps + 1.0,
            std::ceil(substeps * (ratio < 2.8 ? portableExp(portableLog(ratio) / 1.5) : 2.0)));
    else if (ratio < 0.4)
        next = std::floor(substeps * 0.9);
    return int(
        std::clamp(next, double(system.substeps), double(std::max(mostSubsteps, system.substeps))));
}

} // namespace ripstop
