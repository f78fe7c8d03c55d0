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
    TearLimit tear;
    double strain() const { return restLength > 0.0 ? length / restLength - 1.0 : 0.0; }
};

// What the rule of the link looks at, in the unit of its limit.
double measured(const Load& load)
{
    switch (load.tear.rule) {
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

Load loadOf(const System& system, const State& state, const TearLoads& loads, const LinkPlace& link)
{
    const auto index = std::size_t(link.index);
    if (link.kind == LinkKind::Rod)
        return {loads.rodLength[index], loads.restLength[index], state.rodTension[index],
                system.rods[index].tear};
    const Spring& spring = system.springs[index];
    const Vec3 along = state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)];
    const double length = along.norm();
    return {length, spring.restLength,
            length > 0.0 ? loads.springForce[index].dot(along) / length : 0.0, spring.tear};
}

double releasedEnergy(const System& system, const LinkPlace& link, const Load& load)
{
    const auto index = std::size_t(link.index);
    if (link.kind == LinkKind::Rod)
        return 0.5 * load.force * load.force * system.rods[index].compliance;
    const Spring& spring = system.springs[index];
    return elasticEnergy(spring.stiffness, spring.resists, load.length - load.restLength);
}

void tear(const System& system, State& state, int number, const Load& load)
{
    const auto l = std::size_t(number);
    const LinkPlace& link = system.links[l];
    const auto index = std::size_t(link.index);
    if (link.kind == LinkKind::Rod) {
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

// Breaks at most `most` of the overloaded links.
void tearWorst(const System& system, State& state, const TearLoads& loads,
               std::vector<Overload>& overloads, std::size_t most)
{
    const std::size_t count = std::min(most, overloads.size());
    std::partial_sort(overloads.begin(), overloads.begin() + std::ptrdiff_t(count), overloads.end(),
                      [](const Overload& one, const Overload& other) {
                          return one.ratio != other.ratio ? one.ratio > other.ratio
                                                          : one.link < other.link;
                      });
    for (std::size_t i = 0; i < count; ++i) {
        const int link = overloads[i].link;
        tear(system, state, link, loadOf(system, state, loads, system.links[std::size_t(link)]));
    }
}

// Whether a spring is far from breaking, told without a root or a quotient: that is what all but a
// few are, in every substep.
bool isSafe(const System& system, const State& state, const TearLoads& loads, const LinkPlace& link)
{
    const Spring& spring = system.springs[std::size_t(link.index)];
    const Vec3& force = loads.springForce[std::size_t(link.index)];
    const Vec3 separation =
        state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)];
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

} // namespace

void tearLinks(const System& system, State& state, const TearLoads& loads,
               std::vector<Overload>& scratch)
{
    const bool limited = system.tearsPerStep > 0;
    const std::size_t before = state.tears.size() - loads.tearsBefore; // in this time step
    if (limited && before >= std::size_t(system.tearsPerStep))
        return;
    scratch.clear();
    for (const int number : system.tearable) {
        const LinkPlace& link = system.links[std::size_t(number)];
        if (isTorn(link, state))
            continue;
        if (link.kind == LinkKind::Spring && isSafe(system, state, loads, link))
            continue;
        const Load load = loadOf(system, state, loads, link);
        const double value = measured(load);
        if (!(value > load.tear.limit))
            continue;
        if (limited) // above a limit of 0 is infinitely far above it
            scratch.push_back({number, value / load.tear.limit});
        else
            tear(system, state, number, load);
    }
    if (limited)
        tearWorst(system, state, loads, scratch, std::size_t(system.tearsPerStep) - before);
}

} // namespace ripstop
