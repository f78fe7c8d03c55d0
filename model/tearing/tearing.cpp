// tearOverloaded() finds the overloads of springs, rods and panels, leaves one link of each line
// (line_parting.h), lets what is held wait, sorts the rest (by overload where only some may break,
// else by place) and breaks them, noting an event each.
//
// Springs are sifted first by a test without roots, since nearly all are far from their limit in
// every substep.
#include "tearing/tearing.h"

#include "assembly/split_system.h"
#include "forces/spring_force.h"
#include "system/membrane.h"
#include "tearing/line_parting.h"
#include "tearing/panel_tearing.h"
#include "tearing/spar_snapping.h"

#include <algorithm>
#include <cmath>
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
    case TearRule::Tension: // of fabric; links have a force instead
    case TearRule::Strength:
    case TearRule::Energy:
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

double springTension(const System& system, const State& state, std::size_t i) // N, between steps
{
    const Spring& spring = system.springs[i];
    const auto a = std::size_t(spring.a), b = std::size_t(spring.b);
    return springTension(spring, state.position[b] - state.position[a],
                         state.velocity[b] - state.velocity[a]);
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
    double released = releasedEnergy(system, link, load);
    if (system.tearMesh == TearMesh::Vanish)
        for (int k = system.panelsBeside.start[l]; k < system.panelsBeside.start[l + 1]; ++k) {
            const int panel = system.panelsBeside.items[std::size_t(k)];
            released += elasticEnergyIn(system, state, panel);
            state.panelGone[std::size_t(panel)] = 1;
        }
    const Key key = state.splits.empty() ? link.key : TwinOrigins(state.splits).link(link.key);
    const Vec3& a = state.position[std::size_t(link.a)];
    const Vec3& b = state.position[std::size_t(link.b)];
    state.tears.push_back(
        {state.time, key, load.length, load.strain(), load.force, 0.5 * (a + b), released});
}

// A panel that a link has taken along in the same substep does not tear once more.
bool tearPanel(const System& system, State& state, int number)
{
    const Membrane& membrane = system.membranes[std::size_t(number)];
    std::uint8_t& gone = state.panelGone[std::size_t(membrane.panel)];
    if (gone)
        return false;
    noteTear(system, state, membrane, judge(system, state, membrane),
             elasticEnergyIn(system, state, membrane.panel));
    gone = 1;
    return true;
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
    case TearRule::Tension:
    case TearRule::Strength:
    case TearRule::Energy:
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

void findPanelOverloads(const System& system, const State& state, const TearTips& tips,
                        std::vector<Overload>& overloads)
{
    const auto tears = [](const FabricTear& tear) { return tear.rule != TearRule::Never; };
    if (std::ranges::none_of(system.clothTear, tears))
        return;
    for (std::size_t i = 0; i < system.membranes.size(); ++i)
        if (const Membrane& membrane = system.membranes[i];
            !state.panelGone[std::size_t(membrane.panel)] && !tips.isNear(system, membrane.panel))
            if (mayTear(system, state, membrane))
                if (const double ratio = judge(system, state, membrane).worst.ratio; ratio > 1.0)
                    overloads.push_back({int(i), ratio, Overload::Of::Panel});
}

void findSparOverloads(const System& system, const State& state, std::vector<Overload>& overloads)
{
    const std::span<const Bend> spars = system.of<BendLists>().ofSpars();
    for (std::size_t i = 0; i < spars.size(); ++i)
        if (const double ratio = snapRatio(system, state, spars[i]); ratio > 1.0)
            overloads.push_back({int(i), ratio, Overload::Of::Spar});
}

// Springs and rods are gone through as they lie in memory; the links that they are tell the order.
void findLinkOverloads(const System& system, const State& state, const TearLoads& loads,
                       std::vector<Overload>& overloads)
{
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

bool isEdge(const System& system, int link)
{
    const auto l = std::size_t(link);
    return system.panelsBeside.start[l] < system.panelsBeside.start[l + 1];
}

// Whether it is a line that breaks by its force, or a spar. How far a rod has come before
// projection is another in each substep, so that no finer one makes it more true.
bool breaksAlone(const System& system, const Overload& overload)
{
    if (overload.of != Overload::Of::Link)
        return overload.of == Overload::Of::Spar;
    const LinkPlace& link = system.links[std::size_t(overload.element)];
    const auto index = std::size_t(link.index);
    const TearLimit& tear =
        link.kind == LinkKind::Rod ? system.rods[index].tear : system.springs[index].tear;
    return tear.rule == TearRule::Force && !isEdge(system, overload.element);
}

void noteLate(const System& system, const Overload& overload, double& late)
{
    if (breaksAlone(system, overload))
        late = std::max(late, overload.ratio - 1.0);
}

const Bend& sparOf(const System& system, const Overload& overload)
{
    return system.of<BendLists>().ofSpars()[std::size_t(overload.element)];
}

constexpr double farAbove = 1.25; // times the overload that opened the mesh

// What an opening still holds back a step later. It may be infinite, where a limit is 0.
//   easing  s, in which what has let go loses its load
double faded(double hold, double timeStep, double easing)
{
    return std::min(hold, std::numeric_limits<double>::max()) / (1.0 + timeStep / easing);
}

double easingTime(const System& system, const Membrane& membrane)
{
    const PieceLaw law = lawOf(system, membrane);
    double mass = 0.0;
    for (const int corner : system.panels[std::size_t(membrane.panel)].corner)
        mass += system.mass[std::size_t(corner)];
    return std::sqrt(mass / std::min(law.warp, law.weft)) + law.dampingTime;
}

//   overloads  in order
void takeHeldPanelsOut(const System& system, State& state, std::vector<Overload>& overloads,
                       double waits)
{
    auto next = std::ranges::find(overloads, Overload::Of::Panel, &Overload::of);
    for (std::size_t i = 0; i < system.membranes.size(); ++i) {
        const Membrane& membrane = system.membranes[i];
        double& hold = state.panelHold[std::size_t(membrane.panel)];
        const bool isAbove =
            next != overloads.end() && next->of == Overload::Of::Panel && next->element == int(i);
        if (hold > 0.0 && !isAbove)
            hold = 0.0;
        if (hold > 0.0) {
            if (!(next->ratio > farAbove * hold))
                next->ratio = waits;
            hold = faded(hold, system.timeStep, easingTime(system, membrane));
        }
        next += isAbove;
    }
}

// What is held waits until it has been below its limit, is far above it after all, or has had the
// time to lose its load.
void takeHeldOut(const System& system, State& state, std::vector<Overload>& overloads)
{
    std::sort(overloads.begin(), overloads.end(), inOrder);
    const auto find = [&](int link) {
        const auto found =
            std::lower_bound(overloads.begin(), overloads.end(), Overload{link, 0.0}, inOrder);
        const bool isThere =
            found != overloads.end() && found->of == Overload::Of::Link && found->element == link;
        return isThere ? found : overloads.end();
    };
    std::erase_if(state.tearHolds,
                  [&](const TearHold& hold) { return find(hold.link) == overloads.end(); });
    constexpr double waits = 0.0;
    for (TearHold& hold : state.tearHolds) {
        if (const auto found = find(hold.link); !(found->ratio > farAbove * hold.ratio))
            found->ratio = waits;
        hold.ratio = faded(hold.ratio, system.timeStep,
                           easingTime(system, system.links[std::size_t(hold.link)]));
    }
    takeHeldPanelsOut(system, state, overloads, waits);
    std::erase_if(overloads, [](const Overload& overload) { return overload.ratio == waits; });
}

// Breaks at most `most`, and of edges of panels and of panels that share a particle the worst
// alone: the mesh opens there, and the others are about to lose their load.
void tearApart(const System& system, State& state, const TearLoads& loads,
               const std::vector<Overload>& overloads, std::size_t most, double& late)
{
    if (overloads.empty())
        return;
    std::vector<std::uint8_t> opens(state.position.size(), 0);
    const auto takes = [&](std::span<const int> particles) {
        const auto isTaken = [&](int particle) { return opens[std::size_t(particle)] != 0; };
        if (std::ranges::any_of(particles, isTaken))
            return false;
        for (const int particle : particles)
            opens[std::size_t(particle)] = 1;
        return true;
    };
    for (const Overload& overload : overloads) {
        if (most == 0)
            return;
        const auto number = std::size_t(overload.element);
        noteLate(system, overload, late);
        if (overload.of == Overload::Of::Spar) {
            most -= snap(system, state, sparOf(system, overload));
            continue;
        }
        if (overload.of == Overload::Of::Panel) {
            const Membrane& membrane = system.membranes[number];
            if (!takes(system.panels[std::size_t(membrane.panel)].corner))
                continue;
            state.panelHold[std::size_t(membrane.panel)] = -overload.ratio;
            noteTear(system, state, membrane, judge(system, state, membrane), 0.0);
            --most;
            continue;
        }
        const LinkPlace& link = system.links[number];
        if (isEdge(system, overload.element)) {
            if (!takes(std::array{link.a, link.b}))
                continue;
            std::erase_if(state.tearHolds,
                          [&](const TearHold& hold) { return hold.link == overload.element; });
            state.tearHolds.push_back({overload.element, overload.ratio});
        }
        tear(system, state, loads, overload.element);
        --most;
    }
}

} // namespace

void tearOverloaded(const System& system, State& state, const TearLoads& loads,
                    TearScratch& scratch)
{
    const bool splits = system.tearMesh == TearMesh::Split;
    const bool limited = system.tearsPerStep > 0;
    const std::size_t before = state.tears.size() - loads.tearsBefore; // in this time step
    if (limited && before >= std::size_t(system.tearsPerStep))
        return;
    const std::size_t most = limited ? std::size_t(system.tearsPerStep) - before
                                     : std::numeric_limits<std::size_t>::max();
    const bool isOfMesh = !splits || loads.mayPart;
    std::vector<Overload>& overloads = scratch.overloads;
    overloads.clear();
    findLinkOverloads(system, state, loads, overloads);
    if (isOfMesh) {
        scratch.tips.look(system, state);
        findPanelOverloads(system, state, scratch.tips, overloads);
    }
    findSparOverloads(system, state, overloads);
    if (!isOfMesh)
        std::erase_if(overloads, [&](const Overload& one) { return !breaksAlone(system, one); });
    leaveOneOfLines(system, state, overloads);
    if (splits && isOfMesh)
        takeHeldOut(system, state, overloads);
    if (isOfMesh)
        for (const auto& [membrane, ratio] : scratch.tips.overdriven(system, state))
            overloads.push_back({membrane, ratio, Overload::Of::Panel});
    if (limited || splits)
        std::sort(overloads.begin(), overloads.end(), worstFirst);
    else
        std::sort(overloads.begin(), overloads.end(), inOrder);
    if (splits)
        return tearApart(system, state, loads, overloads, most, scratch.late);
    std::size_t torn = 0;
    for (std::size_t i = 0; i < overloads.size() && torn < most; ++i) {
        const Overload& overload = overloads[i];
        noteLate(system, overload, scratch.late);
        switch (overload.of) {
        case Overload::Of::Link:
            tear(system, state, loads, overload.element);
            ++torn;
            break;
        case Overload::Of::Panel:
            torn += tearPanel(system, state, overload.element);
            break;
        case Overload::Of::Spar:
            torn += snap(system, state, sparOf(system, overload));
            break;
        }
    }
}

double mostOverloadOfLines(const System& system, const State& state)
{
    std::vector<Overload> overloads;
    const auto bears = [&](double force, const TearLimit& tear, int link) {
        if (tear.rule == TearRule::Force && force > tear.limit)
            overloads.push_back({link, force / tear.limit});
    };
    for (const int rod : system.tearableRods)
        if (const auto i = std::size_t(rod); !state.rodTorn[i])
            bears(state.rodTension[i], system.rods[i].tear, system.rodLink[i]);
    for (const int spring : system.tearableSprings)
        if (const auto i = std::size_t(spring); !state.springTorn[i])
            bears(springTension(system, state, i), system.springs[i].tear, system.springLink[i]);
    findSparOverloads(system, state, overloads);
    double most = 0.0;
    for (const Overload& overload : overloads)
        noteLate(system, overload, most);
    return most;
}

void noteBreak(const System& system, State& state, int number)
{
    const LinkPlace& link = system.links[std::size_t(number)];
    const auto index = std::size_t(link.index);
    const Vec3& a = state.position[std::size_t(link.a)];
    const Vec3& b = state.position[std::size_t(link.b)];
    Load load{(b - a).norm(), 0.0, 0.0};
    if (link.kind == LinkKind::Rod) {
        load.restLength = system.rods[index].restLength;
        load.force = state.rodTension[index];
    } else {
        load.restLength = system.springs[index].restLength;
        load.force = springTension(system, state, index);
    }
    const Key key = state.splits.empty() ? link.key : TwinOrigins(state.splits).link(link.key);
    state.tears.push_back({state.time, key, load.length, load.strain(), load.force, 0.5 * (a + b),
                           releasedEnergy(system, link, load)});
}

void breakLink(const System& system, State& state, int number)
{
    noteBreak(system, state, number);
    const LinkPlace& link = system.links[std::size_t(number)];
    const auto index = std::size_t(link.index);
    if (link.kind == LinkKind::Rod) {
        state.rodTorn[index] = 1;
        state.rodTension[index] = 0.0;
    } else {
        state.springTorn[index] = 1;
    }
}

} // namespace ripstop
