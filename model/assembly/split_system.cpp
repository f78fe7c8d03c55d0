// Parts the particles of a compiled system, split after split.
//
// Divider::part() checks that a split still has something to part, adds the twin with its share of
// the mass, hangs the panels, links and facets of canopies of its lip on it, doubles the links
// along the tear, and passes a shifted weight on. Later splits may name twins of earlier ones, so
// they go in order of time. addToProbes() and pins follow, as these look at the particles as they
// are in the end. Then finish() puts the rods in order anew, which is why what the start says of
// springs and rods is cleared before.
#include "assembly/split_system.h"

#include "assembly/finish.h"
#include "base/key_index.h"
#include "system/fields.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

class Divider
{
public:
    explicit Divider(System& system)
        : m_system(system)
        , m_particleOf(system.key.size())
        , m_panelOf(system.panelKey.size())
        , m_linkOf(system.links.size())
    {
        for (std::size_t i = 0; i < system.key.size(); ++i)
            m_particleOf.add(system.key[i], int(i));
        for (std::size_t i = 0; i < system.panelKey.size(); ++i)
            m_panelOf.add(system.panelKey[i], int(i));
        for (std::size_t i = 0; i < system.links.size(); ++i)
            m_linkOf.add(system.links[i].key, int(i));
    }

    void part(const Split& split)
    {
        const int from = m_particleOf(split.from);
        if (from < 0 || m_particleOf(split.twin) >= 0 || !hangs(split, from))
            return;
        const int twin = addTwin(split, std::size_t(from));
        for (const Key key : split.panels)
            if (const int panel = m_panelOf(key); panel >= 0) {
                for (int& corner : m_system.panels[std::size_t(panel)].corner)
                    corner = corner == from ? twin : corner;
                moveFacet(panel, from, twin);
            }
        for (const Key key : split.links)
            if (const int link = m_linkOf(key); link >= 0)
                move(m_system.links[std::size_t(link)], from, twin);
        for (const Split::Cut& cut : split.cut)
            if (const int link = m_linkOf(cut.link); link >= 0 && endsAt(link, from))
                addTwinLink(cut, std::size_t(link), from, twin);
        moveWeight(from, twin);
    }

    void pin(Key key)
    {
        if (const int particle = m_particleOf(key); particle >= 0)
            m_system.inverseMass[std::size_t(particle)] = 0.0;
    }

    // Gives a probe of several particles or links the twins of those that it has.
    void addToProbes()
    {
        for (ProbeSpec& probe : m_system.probes) {
            add(m_twins, m_system.key.size(), probe.particles);
            add(m_twinLinks, m_system.links.size(), probe.links);
        }
    }

private:
    using Twins = std::vector<std::pair<int, int>>; // the element, and its twin

    static void add(const Twins& twins, std::size_t count, std::vector<int>& list)
    {
        if (list.size() < 2)
            return;
        std::vector<std::uint8_t> has(count, 0);
        for (const int i : list)
            has[std::size_t(i)] = 1;
        for (const auto& [from, twin] : twins)
            if (has[std::size_t(from)]) {
                has[std::size_t(twin)] = 1;
                list.push_back(twin);
            }
    }

    bool endsAt(int link, int particle) const
    {
        const LinkPlace& place = m_system.links[std::size_t(link)];
        return place.a == particle || place.b == particle;
    }

    bool hangs(const Split& split, int from) const
    {
        const auto hasCorner = [&](Key key) {
            const int panel = m_panelOf(key);
            if (panel < 0)
                return false;
            const auto& corner = m_system.panels[std::size_t(panel)].corner;
            return std::find(corner.begin(), corner.end(), from) != corner.end();
        };
        const auto ends = [&](Key key) {
            const int link = m_linkOf(key);
            return link >= 0 && endsAt(link, from);
        };
        return std::any_of(split.panels.begin(), split.panels.end(), hasCorner)
               || std::any_of(split.links.begin(), split.links.end(), ends);
    }

    int addTwin(const Split& split, std::size_t from)
    {
        System& s = m_system;
        const int twin = int(s.key.size());
        const double mass = split.share * s.mass[from];
        s.mass[from] -= mass;
        if (s.inverseMass[from] > 0.0)
            s.inverseMass[from] = 1.0 / s.mass[from];
        s.key.push_back(split.twin);
        s.mass.push_back(mass);
        s.inverseMass.push_back(1.0 / mass);
        forEachPer<Per::Particle>(
            [&](auto& values) {
                auto value = values[from];
                values.push_back(value);
            },
            s.start);
        if (!s.fabricLayer.empty())
            s.fabricLayer.push_back(FabricLayer(s.fabricLayer[from]));
        m_particleOf.add(split.twin, twin);
        m_twins.emplace_back(int(from), twin);
        return twin;
    }

    // The fabric of a canopy holds its air with the particles that its panels have now.
    void moveFacet(int panel, int from, int twin)
    {
        for (Canopy& canopy : m_system.canopies)
            for (Canopy::Facet& facet : canopy.facets)
                for (int& corner : facet.corner)
                    if (facet.panel == panel && canopy.particles[std::size_t(corner)] == from) {
                        const auto found =
                            std::find(canopy.particles.begin(), canopy.particles.end(), twin);
                        corner = int(found - canopy.particles.begin());
                        if (found == canopy.particles.end())
                            canopy.particles.push_back(twin);
                    }
    }

    void move(LinkPlace& link, int from, int twin)
    {
        const auto swap = [&](int& end) { end = end == from ? twin : end; };
        const auto both = [&](auto& ends) {
            swap(ends.a);
            swap(ends.b);
        };
        both(link);
        if (link.kind == LinkKind::Spring)
            both(m_system.springs[std::size_t(link.index)]);
        else
            both(m_system.rods[std::size_t(link.index)]);
    }

    static void takeShare(double share, Spring& spring)
    {
        spring.stiffness *= share;
        spring.damping *= share;
        if (spring.tear.rule == TearRule::Force)
            spring.tear.limit *= share;
    }

    static void takeShare(double share, Rod& rod)
    {
        rod.compliance /= share;
        if (rod.tear.rule == TearRule::Force)
            rod.tear.limit *= share;
    }

    template <typename T>
    static int share(double share, int index, std::vector<T>& all)
    {
        T twin = all[std::size_t(index)];
        takeShare(share, twin);
        takeShare(1.0 - share, all[std::size_t(index)]);
        all.push_back(twin);
        return int(all.size()) - 1;
    }

    void addTwinLink(const Split::Cut& cut, std::size_t link, int from, int twin)
    {
        System& s = m_system;
        LinkPlace place = s.links[link];
        if (place.kind == LinkKind::Spring) {
            place.index = share(cut.share, place.index, s.springs);
        } else {
            if (!s.direct.empty())
                s.direct.push_back(std::uint8_t(s.direct[std::size_t(place.index)]));
            place.index = share(cut.share, place.index, s.rods);
        }
        place.key = cut.twin;
        const int added = int(s.links.size());
        m_linkOf.add(place.key, added);
        m_twinLinks.emplace_back(int(link), added);
        s.links.push_back(place);
        if (!s.linkStuff.empty())
            s.linkStuff.push_back({}); // of no material, which has no line drag
        if (!s.linkFactors.empty())
            s.linkFactors.push_back(LinkFactors(s.linkFactors[link]));
        move(s.links.back(), from, twin);
    }

    // A rod that holds a shifted weight goes on doing so with the part of the weight that it holds.
    void moveWeight(int from, int twin)
    {
        bool moved = false;
        for (ShiftedRod& shifted : m_system.shiftedRods) {
            const Rod& rod = m_system.rods[std::size_t(shifted.rod)];
            if (shifted.weight == from && rod.a != from && rod.b != from) {
                shifted.weight = twin;
                moved = true;
            }
        }
        for (Input& input : m_system.inputs)
            if (moved && input.kind == ControlKind::WeightShift
                && std::find(input.targets.begin(), input.targets.end(), from)
                       != input.targets.end())
                input.targets.push_back(twin);
    }

    System& m_system;
    KeyIndex m_particleOf;
    KeyIndex m_panelOf;
    KeyIndex m_linkOf;
    Twins m_twins;
    Twins m_twinLinks;
};

} // namespace

std::shared_ptr<System> splitSystem(const System& compiled, std::span<const Split> splits,
                                    std::span<const Key> pins)
{
    auto system = std::make_shared<System>(compiled);
    Divider divider(*system);
    for (const Split& split : splits)
        divider.part(split);
    divider.addToProbes();
    for (const Key pin : pins)
        divider.pin(pin);
    const auto startAnew = [](auto& values) { values.clear(); }; // finish() puts rods in order
    forEachPer<Per::Spring>(startAnew, system->start);
    forEachPer<Per::Rod>(startAnew, system->start);
    finish(*system);
    return system;
}

TwinOrigins::TwinOrigins(std::span<const Split> splits)
{
    for (const Split& split : splits) {
        m_particle.push_back(particle(split.from));
        for (const Split::Cut& cut : split.cut)
            m_link.push_back(link(cut.link));
    }
}

Key TwinOrigins::particle(Key key) const
{
    const std::size_t place = key - firstTwinParticle;
    return key >= firstTwinParticle && place < m_particle.size() ? m_particle[place] : key;
}

Key TwinOrigins::link(Key key) const
{
    const std::size_t place = key - firstTwinLink;
    return key >= firstTwinLink && place < m_link.size() ? m_link[place] : key;
}

} // namespace ripstop
