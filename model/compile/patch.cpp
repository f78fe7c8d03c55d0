#include "compile/patch.h"

#include "assembly/finish.h"
#include "constraints/guides.h"
#include "forces/wing_load.h"

#include <algorithm>

namespace ripstop {
namespace {

// Whether a solver sees no difference: it knows nothing of tears.
bool solvesLike(const Rod& a, const Rod& b)
{
    return a.a == b.a && a.b == b.b && a.restLength == b.restLength && a.compliance == b.compliance
           && a.resists == b.resists;
}

// Whether bends, or the step that they allow, may be others.
bool touchesBends(const Patch& patch)
{
    return !patch.materials.empty() || !patch.particles.empty() || !patch.springs.empty()
           || !patch.rods.empty() || !patch.linkStuff.empty() || !patch.panels.empty();
}

class Patcher
{
public:
    explicit Patcher(System& system)
        : m_system(system)
    {}

    bool run(const Patch& patch)
    {
        m_system.generation = patch.generation;
        m_system.run = patch.run;
        if (patch.settings)
            takeSettings(*patch.settings, m_system);
        for (const auto& [key, material] : patch.materials)
            this->material(key, material);
        for (const auto& [i, values] : patch.particles)
            particle(std::size_t(i), values);
        if (!m_guides.empty())
            setGuides(m_system, std::move(m_guides));
        for (const auto& [link, stuff] : patch.linkStuff)
            this->stuff(stuff, m_system.linkStuff[std::size_t(link)]);
        for (const auto& [link, spring] : patch.springs)
            put(spring, m_system.springs[place(link)]);
        for (const auto& [link, rod] : patch.rods) {
            Rod& held = m_system.rods[place(link)];
            if (!solvesLike(rod, held))
                m_touched.rods.push_back(int(place(link)));
            put(rod, held);
        }
        for (const auto& [i, key] : patch.panels)
            m_system.panels[std::size_t(i)].air = airOf(key);
        items(patch);
        if (m_dragLines)
            listDragLines(m_system);
        if (m_bending || (!m_system.bending.empty() && touchesBends(patch))) {
            listBends(m_system);
            m_allRods = true; // the choice of Solver::Auto hangs on bends
        }
        if (!patch.materials.empty() || !patch.particles.empty() || !patch.panels.empty()
            || patch.winds)
            listWings(m_system);
        if (m_tearRules)
            listTearable(m_system);
        if (m_allRods)
            touchAll(m_system);
        else if (!m_touched.rods.empty() || !m_touched.particles.empty())
            touch(m_system, m_touched);
        return m_layout;
    }

private:
    std::size_t place(int link) const
    {
        return std::size_t(m_system.links[std::size_t(link)].index);
    }

    void material(Key key, const Material& material)
    {
        for (std::size_t i = 0; i < m_system.linkStuff.size(); ++i) {
            const LinkStuff& stuff = m_system.linkStuff[i];
            if (stuff.material != key)
                continue;
            const LinkPlace& link = m_system.links[i];
            if (link.kind == LinkKind::Spring) {
                Spring& spring = m_system.springs[std::size_t(link.index)];
                m_tearRules |= spring.tear.rule != material.tearRule;
                takeMaterial(material, stuff, spring);
            } else {
                Rod& rod = m_system.rods[std::size_t(link.index)];
                m_tearRules |= rod.tear.rule != material.tearRule;
                const Rod before = rod;
                takeMaterial(material, stuff, rod);
                m_allRods |= !solvesLike(rod, before);
            }
        }
        MaterialAir air = ripstop::airOf(Id{key}, material);
        MaterialAir& held = m_system.materialAir[std::size_t(airOf(key))];
        m_dragLines |= air.lineWidth != held.lineWidth;
        held = std::move(air);
        this->bending(std::size_t(airOf(key)), bendingOf(material));
    }

    void bending(std::size_t place, const Bending& bending)
    {
        std::vector<Bending>& all = m_system.bending;
        if ((all.empty() ? Bending() : all[place]) == bending)
            return;
        all.resize(m_system.materialAir.size());
        all[place] = bending;
        if (isLimp(all))
            all.clear();
        m_bending = true;
    }

    void stuff(const LinkStuff& now, LinkStuff& held)
    {
        m_dragLines |= held != now;
        held = now;
    }

    int airOf(Key key) const
    {
        const auto found = std::find_if(m_system.materialAir.begin(), m_system.materialAir.end(),
                                        [&](const MaterialAir& air) { return air.key == key; });
        return int(found - m_system.materialAir.begin());
    }

    void particle(std::size_t i, const ParticleValues& values)
    {
        if (m_system.inverseMass[i] != values.inverseMass)
            m_touched.particles.push_back(int(i));
        m_layout |= (m_system.inverseMass[i] == 0.0) != (values.inverseMass == 0.0);
        guide({int(i), values.guide, values.guideAxis});
        m_system.mass[i] = values.mass;
        m_system.inverseMass[i] = values.inverseMass;
        m_system.start.position[i] = values.position;
        m_system.start.velocity[i] = values.velocity;
    }

    void guide(const GuidedParticle& now)
    {
        const GuidedParticle* held = guideOf(m_system, now.particle);
        if (held ? *held == now : now.guide == Guide::None)
            return;
        m_guides.push_back(now);
        m_touched.particles.push_back(now.particle);
        m_layout = true;
    }

    template <typename T>
    void put(const T& now, T& held)
    {
        m_layout |= held.restLength != now.restLength;
        m_tearRules |= held.tear.rule != now.tear.rule;
        held = now;
    }

    void items(const Patch& patch)
    {
        if (patch.winds) {
            takeWinds(*patch.winds, m_system);
            startGusts(m_system);
        }
        if (patch.obstacles)
            m_system.obstacles = *patch.obstacles;
        if (patch.fabricLayers)
            m_system.fabricLayer = *patch.fabricLayers;
        if (patch.inputs)
            m_system.inputs = *patch.inputs;
        if (patch.probes) {
            m_system.probes = *patch.probes;
            m_layout = true;
        }
        // they hang on the targets of inputs and on where particles start
        if (!patch.inputs && (patch.particles.empty() || m_system.shiftedRods.empty()))
            return;
        std::vector<ShiftedRod> shifted = shiftedRodsOf(m_system);
        if (shifted == m_system.shiftedRods)
            return;
        for (const ShiftedRod& rod : m_system.shiftedRods) // may get its own length back
            m_touched.rods.push_back(rod.rod);
        m_system.shiftedRods = std::move(shifted);
    }

    System& m_system;
    Touched m_touched;
    std::vector<GuidedParticle> m_guides; // that have changed
    bool m_allRods = false;
    bool m_tearRules = false; // have changed
    bool m_dragLines = false; // have changed
    bool m_bending = false;   // has changed
    bool m_layout = false;
};

} // namespace

bool apply(const Patch& patch, System& system) { return Patcher(system).run(patch); }

} // namespace ripstop
