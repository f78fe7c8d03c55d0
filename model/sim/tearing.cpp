#include "sim/tearing.h"

#include "sim/spring_force.h"

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

struct Load
{
    double length;     // m
    double restLength; // m
    double force;      // N, positive in tension
    double strain() const { return restLength > 0.0 ? length / restLength - 1.0 : 0.0; }
};

// What the rule of the link looks at, in the unit of its limit.
double measured(const Load& load, TearRule rule)
{
    switch (rule) {
    case TearRule::Length:
        return load.length;
    case TearRule::Strain:
        return load.strain();
    case TearRule::Force:
        return load.force;
    case TearRule::Never:
        break;
    }
    return -std::numeric_limits<double>::infinity();
}

Load loadOfRod(const State& state, const TearLoads& loads, std::size_t rod)
{
    return {loads.rodLength[rod], loads.restLength[rod], state.rodTension[rod]};
}

Load loadOfSpring(const System& system, const State& state, const TearLoads& loads, std::size_t i)
{
    const Spring& spring = system.springs[i];
    const Vec3 along =
        state.position[std::size_t(spring.b)] - state.position[std::size_t(spring.a)];
    const double length = along.norm();
    return {length, spring.restLength,
            length > 0.0 ? loads.springForce[i].dot(along) / length : 0.0};
}

double releasedEnergy(const System& system, const LinkPlace& link, const Load& load)
{
    const auto index = std::size_t(link.index);
    if (link.kind == LinkKind::Rod)
        return 0.5 * load.force * load.force * system.rods[index].compliance;
    const Spring& spring = system.springs[index];
    return elasticEnergy(spring.stiffness, spring.resists, load.length - load.restLength);
}

void tear(const System& system, State& state, const TearLoads& loads, int number)
{
    const auto l = std::size_t(number);
    const LinkPlace& link = system.links[l];
    const auto index = std::size_t(link.index);
    const bool isRod = link.kind == LinkKind::Rod;
    const Load load =
        isRod ? loadOfRod(state, loads, index) : loadOfSpring(system, state, loads, index);
    if (isRod) {
        state.rodTorn[index] = 1;
        state.rodTension[index] = 0.0;
    } else {
        state.springTorn[index] = 1;
    }
    for (int k = system.panelsBeside.start[l]; k < system.panelsBeside.start[l + 1]; ++k)
        state.panelGone[std::size_t(system.panelsBeside.items[std::size_t(k)])] = 1;
    const Vec3& a = state.position[std::size_t(link.a)];
    const Vec3& b = state.position[std::size_t(link.b)];
    state.tears.push_back({state.time, link.key, load.length, load.strain(), load.force,
                           0.5 * (a + b), releasedEnergy(system, link, load)});
}

// Whether a spring is far from breaking, told without a root or a quotient: that is what all but a
// few are, in every substep.
bool isSafe(const Spring& spring, const State& state, const Vec3& force)
{
    const Vec3 separation =
        state.position[std::size_t(spring.b)] - state.position[std::size_t(spring.a)];
    constexpr double nearly = 1.0 - 1e-9; // what is this near is looked at closely
    switch (spring.tear.rule) {
    case TearRule::Length:
        return separation.squaredNorm() < nearly * spring.tear.limit * spring.tear.limit;
    case TearRule::Strain: {
        const double most = (1.0 + spring.tear.limit) * spring.restLength;
        return separation.squaredNorm() < nearly * most * most;
    }
    case TearRule::Force:
        return force.squaredNorm() < nearly * spring.tear.limit * spring.tear.limit;
    case TearRule::Never:
        break;
    }
    return true;
}

void judge(const Load& load, const TearLimit& tear, int link, std::vector<Overload>& overloads)
{
    const double value = measured(load, tear.rule);
    if (value > tear.limit) // above a limit of 0 is infinitely far above it
        overloads.push_back({link, value / tear.limit});
}

// Springs and rods are gone through as they lie in memory; the links that they are tell the order.
void findOverloads(const System& system, const State& state, const TearLoads& loads,
                   std::vector<Overload>& overloads)
{
    overloads.clear();
    for (const int tearable : system.tearableSprings) {
        const auto i = std::size_t(tearable);
        const Spring& spring = system.springs[i];
        if (!isSafe(spring, state, loads.springForce[i]) && !state.springTorn[i])
            judge(loadOfSpring(system, state, loads, i), spring.tear, system.springLink[i],
                  overloads);
    }
    for (const int tearable : system.tearableRods) {
        const auto i = std::size_t(tearable);
        if (!state.rodTorn[i])
            judge(loadOfRod(state, loads, i), system.rods[i].tear, system.rodLink[i], overloads);
    }
}

} // namespace

void tearLinks(const System& system, State& state, const TearLoads& loads,
               std::vector<Overload>& scratch)
{
    const bool limited = system.tearsPerStep > 0;
    const std::size_t before = state.tears.size() - loads.tearsBefore; // in this time step
    if (limited && before >= std::size_t(system.tearsPerStep))
        return;
    findOverloads(system, state, loads, scratch);
    const auto inOrder = [](const Overload& one, const Overload& other) {
        return one.link < other.link;
    };
    const auto worstFirst = [&](const Overload& one, const Overload& other) {
        return one.ratio != other.ratio ? one.ratio > other.ratio : inOrder(one, other);
    };
    if (limited) {
        std::sort(scratch.begin(), scratch.end(), worstFirst);
        scratch.resize(std::min(scratch.size(), std::size_t(system.tearsPerStep) - before));
    } else {
        std::sort(scratch.begin(), scratch.end(), inOrder);
    }
    for (const Overload& overload : scratch)
        tear(system, state, loads, overload.link);
}

} // namespace ripstop
