// What has a strength is found first, once for a system. forEachLoad() then goes over it and finds
// what it bears; what of that is kept is up to those who call it. Panels go by four.
#include "measure/margins.h"

#include "base/joined_sets.h"
#include "forces/bend_force.h"
#include "forces/spring_force.h"
#include "laws/bend.h"
#include "measure/diagnostics.h"
#include "system/membrane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ripstop {
namespace {

// Links of one material mostly stand beside each other, so that the last one is looked at first.
class StrengthOfLinks
{
public:
    explicit StrengthOfLinks(const System& system)
        : m_system(system)
    {}

    Strength of(std::size_t link)
    {
        if (m_system.strength.empty() || m_system.linkStuff.empty())
            return {}; // that of no material
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
        return pullOfRod(system, state, std::size_t(link.index));
    const auto along = [&](const auto& values) -> Vec3 {
        return values[std::size_t(link.b)] - values[std::size_t(link.a)];
    };
    return springTension(system.springs[std::size_t(link.index)], along(state.position),
                         along(state.velocity));
}

// The strength of what may run along the warp or across it; one that is 0 is not known.
double weaker(double warp, double weft)
{
    return warp > 0.0 && weft > 0.0 ? std::min(warp, weft) : std::max(warp, weft);
}

// Whose pull or moment it is: one link, two beside a moment, or a panel.
struct Loaded
{
    LoadKind kind;
    double load;
    double strength;       // as far as the safety factor goes
    std::array<int, 2> of; // links, or the same panel twice
    bool isPanel = false;

    double margin() const { return load / strength; }
};

// Which of the threads are nearer to their strength, of those that have one.
Loaded loadedPanel(int panel, double warp, double weft, double warpStrength, double weftStrength)
{
    const double ofWarp = warpStrength > 0.0 ? warp / warpStrength : 0.0;
    const double ofWeft = weftStrength > 0.0 ? weft / weftStrength : 0.0;
    const bool isWeft = ofWeft > ofWarp || !(warpStrength > 0.0);
    return {LoadKind::Cloth,
            std::max(isWeft ? weft : warp, 0.0),
            isWeft ? weftStrength : warpStrength,
            {panel, panel},
            true};
}

struct PulledThreads // N/m, per flat width
{
    Pack warp{};
    Pack weft{};
};

// What PanelPull has of each of four panels (system/membrane.h).
PulledThreads pulledThreads(const ClothLawPack& law, const Coordinates& strain)
{
    ClothTensionPack now;
    followLaws(law, strain, now);
    const Coordinates& t = now.tension;
    const Pack warp = law.alongWarp * t.x + law.across * t.y; // strain of what wrinkles
    const Pack weft = law.across * t.x + law.alongWeft * t.y;
    PulledThreads pull;
    for (int lane = 0; lane < 4; ++lane) {
        const bool isTaut = now.isTaut[lane] != 0;
        pull.warp[lane] = t.x[lane] * stretchOf(isTaut ? strain.x[lane] : warp[lane]);
        pull.weft[lane] = t.y[lane] * stretchOf(isTaut ? strain.y[lane] : weft[lane]);
    }
    return pull;
}

template <typename Visit>
void forEachPanel(const System& system, const State& state, const JudgedPlaces::FourPanels& four,
                  Visit&& visit)
{
    Coordinates strain{};
    for (int lane = 0; lane < 4; ++lane)
        if (const int m = four.membrane[std::size_t(lane)]; m >= 0) {
            const Membrane& membrane = system.membranes[std::size_t(m)];
            strain.set(lane, strainAt(membrane, cornersOf(system, membrane, state.position)));
        }
    const PulledThreads pull = pulledThreads(four.law, strain);
    for (int lane = 0; lane < 4; ++lane) {
        const auto k = std::size_t(lane);
        if (four.membrane[k] < 0)
            continue;
        const int panel = system.membranes[std::size_t(four.membrane[k])].panel;
        if (!state.panelGone[std::size_t(panel)])
            visit(loadedPanel(panel, pull.warp[lane], pull.weft[lane], four.warp[k], four.weft[k]));
    }
}

template <typename Visit>
void forEachLoad(const System& system, const State& state, const JudgedPlaces& judged,
                 Visit&& visit)
{
    for (const auto& [i, kind, width, strength] : judged.links) {
        const LinkPlace& link = system.links[std::size_t(i)];
        if (!isTorn(link, state))
            visit(
                Loaded{kind, std::max(pullIn(system, state, link), 0.0) / width, strength, {i, i}});
    }
    for (const JudgedPlaces::FourPanels& four : judged.panels)
        forEachPanel(system, state, four, visit);
    for (const auto& [i, strength] : judged.spars) {
        const Bend& bend = system.of<BendLists>().list[std::size_t(i)];
        visit(Loaded{LoadKind::Spar, bendingMoment(system, state, bend), strength, bend.of});
    }
}

// What a place bore that tore, and its strength; nothing of what has none.
std::optional<Loaded> loadedLink(const State::Tear& tear, const JudgedPlaces& judged)
{
    const auto isIt = [&](int link) { return judged.linkName[std::size_t(link)] == tear.element; };
    for (const auto& [i, kind, width, strength] : judged.links)
        if (isIt(i))
            return Loaded{kind, tear.force / width, strength, {i, i}};
    return std::nullopt;
}

std::optional<Loaded> loadedSpar(const System& system, const State::Tear& tear,
                                 const JudgedPlaces& judged)
{
    for (const auto& [i, strength] : judged.spars) {
        const std::array<int, 2>& of = system.of<BendLists>().list[std::size_t(i)].of;
        for (const int link : of)
            if (judged.linkName[std::size_t(link)] == tear.element)
                return Loaded{LoadKind::Spar, tear.force, strength, {link, link}};
    }
    return std::nullopt;
}

// The force is of the threads that broke. Which these were follows from the strength, the larger
// one of those that were too small.
std::optional<Loaded> loadedPanel(const System& system, const State::Tear& tear,
                                  const JudgedPlaces& judged)
{
    for (const JudgedPlaces::FourPanels& four : judged.panels)
        for (std::size_t k = 0; k < 4 && four.membrane[k] >= 0; ++k) {
            const int panel = system.membranes[std::size_t(four.membrane[k])].panel;
            if (system.panelKey[std::size_t(panel)] != tear.element)
                continue;
            const double larger = std::max(four.warp[k], four.weft[k]);
            const bool isLarger = tear.force >= larger * system.safetyFactor;
            return Loaded{LoadKind::Cloth,
                          tear.force,
                          isLarger ? larger : weaker(four.warp[k], four.weft[k]),
                          {panel, panel},
                          true};
        }
    return std::nullopt;
}

std::optional<Loaded> loadedOnce(const System& system, const State::Tear& tear,
                                 const JudgedPlaces& judged)
{
    if (tear.length == 0.0) // a spar has snapped
        return loadedSpar(system, tear, judged);
    const std::optional<Loaded> link = loadedLink(tear, judged);
    return link ? link : loadedPanel(system, tear, judged);
}

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

TearLimit tearOf(const System& system, const LinkPlace& link)
{
    const auto i = std::size_t(link.index);
    return link.kind == LinkKind::Rod ? system.rods[i].tear : system.springs[i].tear;
}

// What it tears at comes before what its material could bear; N, or N/m of a width.
double borneBy(const TearLimit& tear, double width, double strength)
{
    return tear.rule == TearRule::Force && tear.limit > 0.0 ? tear.limit / width : strength;
}

LinkStuff stuffOf(const System& system, int link)
{
    return system.linkStuff.empty() ? LinkStuff() : system.linkStuff[std::size_t(link)];
}

void judgeLinks(const System& system, JudgedPlaces& judged)
{
    StrengthOfLinks strengths(system);
    for (int i = 0; i < int(system.links.size()); ++i) {
        const Strength strength = strengths.of(std::size_t(i));
        const LinkStuff stuff = stuffOf(system, i);
        const bool isThread = stuff.role == LinkRole::Thread && stuff.width > 0.0;
        const double bears = isThread                       ? weaker(strength.warp, strength.weft)
                             : stuff.role == LinkRole::Line ? strength.line
                                                            : 0.0;
        const double width = isThread ? stuff.width : 1.0;
        const double most = borneBy(tearOf(system, system.links[std::size_t(i)]), width,
                                    bears * system.factorsOf(std::size_t(i)).strength);
        if (most > 0.0)
            judged.links.push_back({i, isThread ? LoadKind::Thread : LoadKind::Line, width,
                                    most / system.safetyFactor});
    }
}

void judgePanels(const System& system, JudgedPlaces& judged)
{
    std::size_t count = 0;
    for (int i = 0; i < int(system.membranes.size()); ++i) {
        const Membrane& membrane = system.membranes[std::size_t(i)];
        const PieceLaw law = lawOf(system, membrane);
        const auto cloth = std::size_t(system.panels[std::size_t(membrane.panel)].air);
        Strength strength = system.strength.empty() ? Strength() : system.strength[cloth];
        if (const FabricTear& tear = system.clothTear[cloth]; tear.rule == TearRule::Tension) {
            strength.warp = std::isfinite(tear.warp) ? tear.warp : strength.warp;
            strength.weft = std::isfinite(tear.weft) ? tear.weft : strength.weft;
        }
        if (!law.isElastic() || !(weaker(strength.warp, strength.weft) > 0.0))
            continue;
        const std::size_t k = count++ % 4;
        if (k == 0)
            judged.panels.emplace_back();
        JudgedPlaces::FourPanels& four = judged.panels.back();
        const double factor = membrane.factors.strength;
        four.membrane[k] = i;
        four.law.set(int(k), law);
        four.warp[k] = factor * strength.warp / system.safetyFactor;
        four.weft[k] = factor * strength.weft / system.safetyFactor;
    }
}

void judgeSpars(const System& system, JudgedPlaces& judged)
{
    StrengthOfLinks strengths(system);
    const std::vector<Bend>& bends = system.of<BendLists>().list;
    for (int i = 0; i < int(bends.size()); ++i) {
        const Bend& bend = bends[std::size_t(i)];
        if (!bend.ofSpar)
            continue;
        const double factor = std::min(system.factorsOf(std::size_t(bend.of[0])).strength,
                                       system.factorsOf(std::size_t(bend.of[1])).strength);
        if (const double bears = strengths.of(std::size_t(bend.of[0])).moment; bears > 0.0)
            judged.spars.push_back({i, factor * bears / system.safetyFactor});
    }
}

// Most designs without materials have neither strengths nor limits, and need not be gone through
// at every frame to know it.
bool mayBreak(const System& system)
{
    return !system.strength.empty() || !system.tearableSprings.empty()
           || !system.tearableRods.empty()
           || std::ranges::any_of(system.clothTear, [](const FabricTear& tear) {
                  return tear.rule != TearRule::Never;
              });
}

// The links of lines that meet at a particle; of more than two, how many there are tells enough.
struct LineEnds
{
    int count = 0;
    std::array<int, 2> links{};
};

std::vector<LineEnds> lineEndsOf(const System& system)
{
    std::vector<LineEnds> ends(system.start.position.size());
    for (int i = 0; i < int(system.links.size()); ++i) {
        if (stuffOf(system, i).role != LinkRole::Line)
            continue;
        const LinkPlace& link = system.links[std::size_t(i)];
        for (const int particle : {link.a, link.b})
            if (LineEnds& there = ends[std::size_t(particle)]; there.count++ < 2)
                there.links[std::size_t(there.count - 1)] = i;
    }
    return ends;
}

// Links, by their places in System::links, that are one line or one spar.
JoinedSets chainsOf(const System& system)
{
    JoinedSets chains(system.links.size());
    for (const auto& [count, links] : lineEndsOf(system))
        if (count == 2 && stuffOf(system, links[0]).material == stuffOf(system, links[1]).material)
            chains.join(links[0], links[1]);
    for (const Bend& bend : system.of<BendLists>().list)
        if (bend.ofSpar)
            chains.join(bend.of[0], bend.of[1]);
    return chains;
}

} // namespace

JudgedPlaces unnamedPlacesOf(const System& system)
{
    JudgedPlaces judged;
    if (!mayBreak(system))
        return judged;
    judgeLinks(system, judged);
    judgePanels(system, judged);
    judgeSpars(system, judged);
    return judged;
}

JudgedPlaces judgedPlacesOf(const System& system)
{
    JudgedPlaces judged = unnamedPlacesOf(system);
    if (judged.isEmpty())
        return judged;
    JoinedSets chains = chainsOf(system);
    for (int i = 0; i < int(system.links.size()); ++i) {
        judged.linkName.push_back(system.links[std::size_t(i)].key);
        judged.lineName.push_back(system.links[std::size_t(chains.of(i))].key);
    }
    return judged;
}

Margins margins(const System& system, const State& state)
{
    Margins result;
    fillMargins(system, state, unnamedPlacesOf(system), result);
    return result;
}

void fillMargins(const System& system, const State& state, const JudgedPlaces& judged,
                 Margins& result)
{
    result.link.clear();
    result.panel.clear();
    if (judged.isEmpty())
        return;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    result.link.assign(system.links.size(), none);
    result.panel.assign(system.panels.size(), none);
    forEachLoad(system, state, judged, [&](const Loaded& loaded) {
        for (const int element : loaded.of) {
            double& held = (loaded.isPanel ? result.panel : result.link)[std::size_t(element)];
            held = std::fmax(held, loaded.margin()); // passes over what is no number
        }
    });
}

namespace {

LoadedPlace placeOf(const System& system, const JudgedPlaces& judged, const Loaded& loaded)
{
    const auto of = std::size_t(loaded.of[0]);
    const Key element = loaded.isPanel ? system.panelKey[of] : judged.linkName[of];
    const bool isOfLine = loaded.kind == LoadKind::Line || loaded.kind == LoadKind::Spar;
    LoadedPlace place;
    place.element = element;
    place.whole = isOfLine ? judged.lineName[of] : element;
    place.material = loaded.isPanel ? system.materialAir[std::size_t(system.panels[of].air)].key
                                    : stuffOf(system, loaded.of[0]).material;
    if (loaded.isPanel)
        for (std::size_t k = 0; k < 3; ++k)
            place.corners[k] = system.key[std::size_t(system.panels[of].corner[k])];
    place.kind = loaded.kind;
    place.load = loaded.load;
    place.strength = loaded.strength;
    return place;
}

} // namespace

void offerPlaces(const System& system, const State& state, const JudgedPlaces& judged,
                 WorstPlaces& worst)
{
    forEachLoad(system, state, judged, [&](const Loaded& loaded) {
        if (!worst.wants(loaded.margin()))
            return;
        LoadedPlace place = placeOf(system, judged, loaded);
        place.time = state.time;
        place.place = middleOf(system, state, loaded);
        worst.offer(place);
    });
}

LoadedPlace tornPlace(const System& system, const State::Tear& tear, const JudgedPlaces& judged)
{
    LoadedPlace place;
    if (const std::optional<Loaded> loaded = loadedOnce(system, tear, judged)) {
        place = placeOf(system, judged, *loaded);
    } else {
        place.element = place.whole = tear.element;
        place.kind = tear.length == 0.0                                      ? LoadKind::Spar
                     : std::ranges::count(system.panelKey, tear.element) > 0 ? LoadKind::Cloth
                                                                             : LoadKind::Line;
        place.load = tear.force;
    }
    place.time = tear.time;
    place.place = tear.place;
    place.torn = true;
    return place;
}

} // namespace ripstop
