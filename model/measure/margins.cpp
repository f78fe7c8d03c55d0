// forEachLoad() goes once over links, elastic panels and spars and finds load and strength of each
// that has one; what it is asked for is kept by those who call it. Links of one material mostly
// stand beside each other, so that the strength of the last one is mostly that of the next.
#include "measure/margins.h"

#include "base/bend.h"
#include "forces/spring_force.h"
#include "system/membrane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace ripstop {
namespace {

class StrengthOfLinks
{
public:
    explicit StrengthOfLinks(const System& system)
        : m_system(system)
    {}

    const Strength& of(std::size_t link)
    {
        if (m_system.linkStuff.empty())
            return m_system.strength.front(); // that of no material
        const Key material = m_system.linkStuff[link].material;
        if (m_system.materialAir[m_last].key != material) {
            const auto found = std::ranges::find(m_system.materialAir, material, &MaterialAir::key);
            m_last = found == m_system.materialAir.end()
                         ? 0
                         : std::size_t(found - m_system.materialAir.begin());
        }
        return m_system.strength[m_last];
    }

private:
    const System& m_system;
    std::size_t m_last = 0;
};

double pullIn(const System& system, const State& state, const LinkPlace& link)
{
    if (link.kind == LinkKind::Rod)
        return state.rodTension[std::size_t(link.index)];
    const auto along = [&](const auto& values) -> Vec3 {
        return values[std::size_t(link.b)] - values[std::size_t(link.a)];
    };
    return springTension(system.springs[std::size_t(link.index)], along(state.position),
                         along(state.velocity));
}

// The strength of a strip of threads, of which it is not known which way they run.
double weaker(const Strength& strength)
{
    if (strength.warp > 0.0 && strength.weft > 0.0)
        return std::min(strength.warp, strength.weft);
    return std::max(strength.warp, strength.weft);
}

// Whose pull or moment it is: one link, two beside a moment, or a panel.
struct Loaded
{
    LoadKind kind;
    double load;
    double strength;       // as far as the safety factor goes
    std::array<int, 2> of; // links, or the same panel twice
    bool isPanel = false;
};

template <typename Visit>
void forEachLink(const System& system, const State& state, Visit&& visit)
{
    StrengthOfLinks strengths(system);
    for (std::size_t i = 0; i < system.links.size(); ++i) {
        const Strength& strength = strengths.of(i);
        const LinkStuff stuff = system.linkStuff.empty() ? LinkStuff() : system.linkStuff[i];
        const bool isThread = stuff.role == LinkRole::Thread && stuff.width > 0.0;
        const double bears = isThread                       ? weaker(strength)
                             : stuff.role == LinkRole::Line ? strength.line
                                                            : 0.0;
        if (!(bears > 0.0) || isTorn(system.links[i], state))
            continue;
        const double pull = std::max(pullIn(system, state, system.links[i]), 0.0);
        visit(Loaded{isThread ? LoadKind::Thread : LoadKind::Line,
                     isThread ? pull / stuff.width : pull,
                     bears / system.safetyFactor,
                     {int(i), int(i)}});
    }
}

template <typename Visit>
void forEachElasticPanel(const System& system, const State& state, Visit&& visit)
{
    for (const Membrane& membrane : system.membranes) {
        const auto panel = std::size_t(membrane.panel);
        const Strength& strength = system.strength[std::size_t(system.panels[panel].air)];
        if (state.panelGone[panel] || !(weaker(strength) > 0.0))
            continue;
        const PanelPull pull =
            pullOf(system, membrane, cornersOf(system, membrane, state.position));
        if (!pull.carries)
            continue;
        const auto orNever = [](double limit) {
            return limit > 0.0 ? limit : FabricTear::unbreakable;
        };
        const bool isWeft =
            threadLoad(pull, {TearRule::Tension, orNever(strength.warp), orNever(strength.weft)})
                    .threads
                == 1
            || !(strength.warp > 0.0);
        visit(Loaded{LoadKind::Cloth,
                     std::max(isWeft ? pull.weft : pull.warp, 0.0),
                     (isWeft ? strength.weft : strength.warp) / system.safetyFactor,
                     {membrane.panel, membrane.panel},
                     true});
    }
}

template <typename Visit>
void forEachMoment(const System& system, const State& state, Visit&& visit)
{
    StrengthOfLinks strengths(system);
    for (const Bend& bend : system.of<BendLists>().list) {
        if (!bend.ofSpar)
            continue;
        const double bears = strengths.of(std::size_t(bend.of[0])).moment;
        if (bears > 0.0)
            visit(Loaded{LoadKind::Spar, bendingMoment(system, state, bend),
                         bears / system.safetyFactor, bend.of});
    }
}

template <typename Visit>
void forEachLoad(const System& system, const State& state, Visit&& visit)
{
    if (system.strength.empty())
        return;
    forEachLink(system, state, visit);
    forEachElasticPanel(system, state, visit);
    forEachMoment(system, state, visit);
}

// Numbers that are joined two by two into sets, each known by its lowest.
class Joined
{
public:
    explicit Joined(std::size_t count)
        : m_above(count)
    {
        std::iota(m_above.begin(), m_above.end(), 0);
    }

    void join(int a, int b)
    {
        const auto [low, high] = std::minmax({first(a), first(b)});
        m_above[std::size_t(high)] = low;
    }

    std::vector<int> firsts()
    {
        for (int i = 0; i < int(m_above.size()); ++i)
            m_above[std::size_t(i)] = first(i);
        return std::move(m_above);
    }

private:
    int first(int i)
    {
        while (m_above[std::size_t(i)] != i) {
            int& above = m_above[std::size_t(i)];
            above = m_above[std::size_t(above)]; // half of the way next time
            i = above;
        }
        return i;
    }

    std::vector<int> m_above;
};

Vec3 middleOf(const System& system, const State& state, const Loaded& loaded)
{
    const auto at = [&](int particle) -> Vec3 { return state.position[std::size_t(particle)]; };
    if (loaded.isPanel) {
        const auto& [a, b, c] = system.panels[std::size_t(loaded.of[0])].corner;
        return (at(a) + at(b) + at(c)) / 3.0;
    }
    const LinkPlace& link = system.links[std::size_t(loaded.of[0])];
    if (loaded.kind != LoadKind::Spar)
        return 0.5 * (at(link.a) + at(link.b));
    const LinkPlace& other = system.links[std::size_t(loaded.of[1])];
    return at(link.a == other.a || link.a == other.b ? link.a : link.b);
}

} // namespace

double bendingMoment(const System& system, const State& state, const Bend& spar)
{
    for (const int link : spar.of)
        if (isTorn(system.links[std::size_t(link)], state))
            return 0.0;
    const Vec3& at = state.position[std::size_t(spar.corner[0])];
    const Vec3 turn = turnOf(spar, {Vec3(state.position[std::size_t(spar.corner[1])] - at),
                                    Vec3(state.position[std::size_t(spar.corner[2])] - at)})
                          .turn;
    // The turn is 2 L sin(angle / 2), and the energy half of the stiffness times its square. L is
    // what turns: less at a clamp, where half of it is held.
    const double length = spar.weight[1] * spar.length[0];
    const double size = turn.norm();
    const double sine = std::min(size / (2.0 * length), 1.0);
    return std::abs(spar.stiffness * (size - spar.restTurn)) * length
           * std::sqrt(1.0 - sine * sine);
}

Margins margins(const System& system, const State& state)
{
    Margins result;
    if (system.strength.empty())
        return result;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    result.link.assign(system.links.size(), none);
    result.panel.assign(system.panels.size(), none);
    forEachLoad(system, state, [&](const Loaded& loaded) {
        for (const int element : loaded.of) {
            double& held = (loaded.isPanel ? result.panel : result.link)[std::size_t(element)];
            held = std::fmax(held, loaded.load / loaded.strength); // passes over what is no number
        }
    });
    return result;
}

std::vector<int> chainsOf(const System& system)
{
    if (system.strength.empty())
        return {};
    Joined joined(system.links.size());
    const auto stuffOf = [&](int link) {
        return system.linkStuff.empty() ? LinkStuff() : system.linkStuff[std::size_t(link)];
    };
    struct Ends
    {
        int count = 0;
        std::array<int, 2> links{};
    };
    std::vector<Ends> ends(system.start.position.size());
    for (int i = 0; i < int(system.links.size()); ++i) {
        if (stuffOf(i).role != LinkRole::Line)
            continue;
        const LinkPlace& link = system.links[std::size_t(i)];
        for (const int particle : {link.a, link.b})
            if (Ends& there = ends[std::size_t(particle)]; there.count++ < 2)
                there.links[std::size_t(there.count - 1)] = i;
    }
    for (const Ends& there : ends)
        if (there.count == 2
            && stuffOf(there.links[0]).material == stuffOf(there.links[1]).material)
            joined.join(there.links[0], there.links[1]);
    for (const Bend& bend : system.of<BendLists>().list)
        if (bend.ofSpar)
            joined.join(bend.of[0], bend.of[1]);
    return joined.firsts();
}

void offerPlaces(const System& system, const State& state, std::span<const int> lines,
                 WorstPlaces& worst)
{
    forEachLoad(system, state, [&](const Loaded& loaded) {
        if (!worst.wants(loaded.load / loaded.strength))
            return;
        const auto of = std::size_t(loaded.of[0]);
        const Key element = loaded.isPanel ? system.panelKey[of] : system.links[of].key;
        const bool isOfLine = loaded.kind == LoadKind::Line || loaded.kind == LoadKind::Spar;
        worst.offer({element, isOfLine ? system.links[std::size_t(lines[of])].key : element,
                     loaded.kind, loaded.load, loaded.strength, state.time,
                     middleOf(system, state, loaded)});
    });
}

} // namespace ripstop
