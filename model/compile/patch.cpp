// A patch puts values in their places, first settings and materials, then particles, links, panels
// and items, and notes what that touches. Last, the lists that depend on these values are made
// again, and only as far as they are touched.
#include "compile/patch.h"

#include "assembly/finish.h"
#include "constraints/guides.h"
#include "derived/tear_bounds.h"
#include "forces/forces.h"

#include <algorithm>

namespace ripstop {
namespace {

// Whether a solver sees no difference: it knows nothing of tears.
bool solvesLike(const Rod& a, const Rod& b)
{
    return a.a == b.a && a.b == b.b && a.restLength == b.restLength && a.compliance == b.compliance
           && a.resists == b.resists && a.dampingTime == b.dampingTime;
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
        m_solver = patch.settings
                   && (patch.settings->solver != m_system.solver
                       || patch.settings->timeStep != m_system.timeStep);
        if (patch.settings)
            takeSettings(*patch.settings, m_system);
        for (const auto& [key, material] : patch.materials)
            this->material(key, material);
        for (const auto& [i, row] : patch.particles)
            particle(i, row);
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
        for (const auto& [key, law] : patch.laws)
            cloth(airOf(key), law);
        for (const auto& [i, cut] : patch.cuts)
            ofPanels<PanelCut>(cut, m_system.membranes[std::size_t(i)]);
        for (const auto& [i, factor] : patch.factors)
            ofPanels(factor, m_system.membranes[std::size_t(i)].factors.stiffness);
        items(patch);
        // the choice of Solver::Auto hangs on what bounds the substep
        m_allRods |= listForces(m_system, edited(patch));
        if (m_tearRules)
            listTearable(m_system);
        if (m_allRods)
            touchAll(m_system);
        else if (!m_touched.rods.empty() || !m_touched.particles.empty())
            touch(m_system, m_touched);
        return m_layout;
    }

private:
    Edited edited(const Patch& patch) const
    {
        return {.materials = !patch.materials.empty(),
                .particles = !patch.particles.empty(),
                .links = !patch.springs.empty() || !patch.rods.empty(),
                .linkStuff = m_linkStuff,
                .panels = !patch.panels.empty(),
                .winds = patch.winds.has_value(),
                .solver = m_solver};
    }

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
            const LinkFactors factors = m_system.factorsOf(i);
            if (link.kind == LinkKind::Spring) {
                Spring& spring = m_system.springs[std::size_t(link.index)];
                const TearRule before = spring.tear.rule;
                takeMaterial(material, stuff, factors, spring);
                m_tearRules |= spring.tear.rule != before;
            } else {
                Rod& rod = m_system.rods[std::size_t(link.index)];
                const Rod before = rod;
                takeMaterial(material, stuff, factors, rod);
                m_tearRules |= rod.tear.rule != before.tear.rule;
                m_allRods |= !solvesLike(rod, before);
            }
        }
        m_system.materialAir[std::size_t(airOf(key))] = ripstop::airOf(Id{key}, material);
        this->bending(std::size_t(airOf(key)), bendingOf(material));
        strength(std::size_t(airOf(key)), strengthOf(material));
        cloth(airOf(key), clothOf(material));
        if (!m_system.clothTear.empty())
            m_system.clothTear[std::size_t(airOf(key))] = fabricTearOf(material);
    }

    void cloth(int place, const ClothLaw& law)
    {
        if (m_system.cloth.empty())
            return;
        ofPanels(law, m_system.cloth[std::size_t(place)]);
    }

    // What the solver of panels looks at.
    template <typename T>
    void ofPanels(const T& now, T& held)
    {
        m_allRods |= held != now;
        held = now;
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
    }

    void strength(std::size_t place, const Strength& strength)
    {
        std::vector<Strength>& all = m_system.strength;
        all.resize(m_system.materialAir.size());
        all[place] = strength;
        if (hasNone(all))
            all.clear();
    }

    void stuff(const LinkStuff& now, LinkStuff& held)
    {
        m_linkStuff |= held != now;
        held = now;
    }

    int airOf(Key key) const
    {
        const auto found = std::find_if(m_system.materialAir.begin(), m_system.materialAir.end(),
                                        [&](const MaterialAir& air) { return air.key == key; });
        return int(found - m_system.materialAir.begin());
    }

    void particle(int place, const Particle& row)
    {
        const auto i = std::size_t(place);
        const double before = m_system.inverseMass[i];
        guide(guidedOf(row, place));
        takeParticle(row, place, m_system);
        const double now = m_system.inverseMass[i];
        if (before != now)
            m_touched.particles.push_back(place);
        m_layout |= (before == 0.0) != (now == 0.0);
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
        if (patch.winds)
            takeWinds(*patch.winds, m_system);
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
    bool m_solver = false;    // has changed
    bool m_tearRules = false; // have changed
    bool m_linkStuff = false; // has changed
    bool m_layout = false;
};

} // namespace

bool apply(const Patch& patch, System& system) { return Patcher(system).run(patch); }

} // namespace ripstop
