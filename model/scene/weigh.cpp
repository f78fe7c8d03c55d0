// Weighs particles in two ways that share one set of sums:
// 1. Scales adds up, over all panels and links of a material, what a density per area or per
//    length gives to each particle.
// 2. weighed() takes the differences of the densities that an edit changes from one known value to
//    another, and adds the masses that follow, moved to others of a part by
//    Scales::moveToCarriers() where a mass would not stay above zero; it fails where that does not
//    help.
// 3. weighing() takes the densities themselves, and sets the masses of all particles that get any.
#include "scene/weigh.h"

#include "scene/element_index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop {
namespace {

// Sums up what panels and links of some materials give to particles.
class Scales
{
public:
    explicit Scales(const Scene& scene)
        : m_scene(&scene)
        , m_index(scene)
    {
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Particle& particle : part.particles)
                m_particles.push_back(&particle);
        });
        m_mass.resize(m_particles.size());
    }

    // Adds what a material gives: mass per area of panels, kg/m^2, and per length of links, kg/m.
    void add(Id material, double areal, double linear)
    {
        forEachPart(*m_scene, [&](Id, const Part& part) {
            for (const Panel& panel : part.panels)
                if (panel.material == material && areal != 0.0)
                    addPanel(panel, areal);
            for (const Link& link : part.links)
                if (link.material == material && linear != 0.0)
                    for (const Id end : {link.from, link.to})
                        give(end, 0.5 * linear * link.restLength);
        });
    }

    // All that the materials of the scene say.
    void addAll()
    {
        for (const Entry& entry : m_scene->items)
            if (const Material* material = std::get_if<Material>(&entry.item))
                add(entry.id, material->arealDensity.value_or(0.0),
                    material->linearDensity.value_or(0.0));
    }

    // What is given to a particle that has less than `said`, what its materials say, is given to
    // it for the share that it has; the rest goes to those free particles of its part that have
    // more, as far as they have it. So a frame is weighed of which others carry a part.
    void moveToCarriers(const Scales& said)
    {
        std::size_t first = 0;
        forEachPart(*m_scene, [&](Id, const Part& part) {
            double rest = 0.0, more = 0.0; // kg
            const auto excess = [&](std::size_t i) {
                const Particle& particle = *m_particles[i];
                return particle.pinned ? 0.0 : std::max(0.0, particle.mass - said.m_mass[i]);
            };
            const std::size_t last = first + part.particles.size();
            for (std::size_t i = first; i < last; ++i) {
                more += excess(i);
                if (!(m_particles[i]->mass < said.m_mass[i]))
                    continue;
                const double own = m_mass[i] * m_particles[i]->mass / said.m_mass[i];
                rest += m_mass[i] - own;
                m_mass[i] = own;
            }
            for (std::size_t i = first; more > 0.0 && i < last; ++i)
                m_mass[i] += rest * excess(i) / more;
            first = last;
        });
    }

    // In sum, but for rounding; a part may have nothing that carries the rest.
    bool givesAsMuchAs(const Scales& other) const
    {
        const auto sum = [](const Scales& one) {
            return std::accumulate(one.m_mass.begin(), one.m_mass.end(), 0.0);
        };
        return std::abs(sum(*this) - sum(other)) <= 1e-9 * std::abs(sum(other));
    }

    // The first particle that would be left without mass, or null.
    const Particle* tooLight() const
    {
        for (std::size_t i = 0; i < m_mass.size(); ++i)
            if (m_mass[i] != 0.0 && !(m_particles[i]->mass + m_mass[i] > 0.0))
                return m_particles[i];
        return nullptr;
    }

    // Calls visit(particle, mass in kg) for each particle that is given any.
    template <typename Visit>
    void forEachGiven(Visit visit) const
    {
        for (std::size_t i = 0; i < m_mass.size(); ++i)
            if (m_mass[i] != 0.0)
                visit(*m_particles[i], m_mass[i]);
    }

private:
    // A reference to nothing is passed over, since check.cpp reports it.
    const Particle* find(Id particle) const
    {
        const int place = m_index.particle(particle);
        return place < 0 ? nullptr : m_particles[std::size_t(place)];
    }

    void give(Id particle, double mass)
    {
        if (const int place = m_index.particle(particle); place >= 0)
            m_mass[std::size_t(place)] += mass;
    }

    void addPanel(const Panel& panel, double density)
    {
        const Particle* const a = find(panel.a);
        const Particle* const b = find(panel.b);
        const Particle* const c = find(panel.c);
        if (!a || !b || !c)
            return;
        const Vec3 across = (b->position - a->position).cross(c->position - a->position);
        for (const Particle* corner : {a, b, c})
            give(corner->id, density * 0.5 * across.norm() / 3.0);
    }

    const Scene* m_scene;
    ElementIndex m_index;
    std::vector<const Particle*> m_particles; // as the index counts them
    std::vector<double> m_mass;               // [particles] kg
};

SetValues noMasses() { return {&propertyOf<&Particle::mass>(), {}, {}}; }

} // namespace

bool weighs(const Property& property)
{
    return isOneOf<&Material::arealDensity, &Material::linearDensity>(property);
}

Result<Edit> weighed(const Scene& scene, Edit edit)
{
    struct More
    {
        Id material;
        double areal;  // kg/m^2
        double linear; // kg/m
    };
    std::vector<More> more;
    for (const Change& change : edit.changes) {
        const SetValues* const set = std::get_if<SetValues>(&change);
        if (!set || !weighs(*set->property))
            continue;
        const bool areal = isOneOf<&Material::arealDensity>(*set->property);
        for (std::size_t i = 0; i < set->targets.size(); ++i) {
            const Material* material = findItem<Material>(scene, set->targets[i]);
            const Value& value = set->values[set->values.size() == 1 ? 0 : i];
            const double* const now = std::get_if<double>(&value);
            const auto& before = areal ? material->arealDensity : material->linearDensity;
            if (now && before && *now != *before)
                more.push_back(
                    {set->targets[i], areal ? *now - *before : 0.0, areal ? 0.0 : *now - *before});
        }
    }
    if (more.empty())
        return edit;
    Scales scales(scene);
    for (const More& one : more)
        scales.add(one.material, one.areal, one.linear);
    if (const Particle* light = scales.tooLight()) {
        Scales said(scene), moved = scales;
        said.addAll();
        moved.moveToCarriers(said);
        if (moved.tooLight() || !moved.givesAsMuchAs(scales))
            return Failure(
                "Particle %1 weighs less than the densities of its materials say, of all "
                "panels and lines that end there: have them weigh it first, as "
                "ripstop-cli weigh does, or empty the density of the material.",
                std::uint32_t(light->id));
        scales = std::move(moved);
    }
    SetValues masses = noMasses();
    scales.forEachGiven([&](const Particle& particle, double mass) {
        masses.targets.push_back(particle.id);
        masses.values.emplace_back(particle.mass + mass);
    });
    if (!masses.targets.empty())
        edit.changes.push_back({std::move(masses)});
    return edit;
}

Edit weighing(const Scene& scene)
{
    Scales scales(scene);
    scales.addAll();
    SetValues masses = noMasses();
    scales.forEachGiven([&](const Particle& particle, double mass) {
        masses.targets.push_back(particle.id);
        masses.values.emplace_back(mass);
    });
    Edit edit{Message("Weigh"), {}};
    if (!masses.targets.empty())
        edit.changes.push_back({std::move(masses)});
    return edit;
}

} // namespace ripstop
