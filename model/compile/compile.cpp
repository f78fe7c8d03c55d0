#include "compile/compile.h"

#include "scene/check.h"

#include <algorithm>
#include <unordered_map>

namespace ripstop {
namespace {

class Compiler
{
public:
    explicit Compiler(const Scene& scene)
        : m_scene(scene)
    {}

    std::shared_ptr<const System> run(std::uint64_t generation, std::uint64_t runNumber)
    {
        m_system->generation = generation;
        m_system->run = runNumber;
        settings();
        forEachPart(m_scene, [&](Id, const Part& part) { particles(part); });
        forEachPart(m_scene, [&](Id, const Part& part) { elements(part); });
        for (const Entry& entry : m_scene.items) {
            if (const Wind* wind = std::get_if<Wind>(&entry.item))
                m_system->wind += wind->velocity;
            if (const Collider* collider = std::get_if<Collider>(&entry.item))
                obstacle(*collider);
            if (const Control* control = std::get_if<Control>(&entry.item))
                input(entry.id, *control);
            if (const Probe* probe = std::get_if<Probe>(&entry.item))
                this->probe(entry.id, *probe);
        }
        shiftedRods();
        finish(*m_system);
        return m_system;
    }

private:
    void settings()
    {
        const Settings& settings = m_scene.settings;
        m_system->timeStep = settings.timeStep;
        m_system->substeps = settings.substeps;
        m_system->sweeps = settings.sweeps;
        m_system->integrator = settings.integrator;
        m_system->solver = settings.solver;
        m_system->gravity = settings.gravity;
        m_system->airDensity = settings.airDensity;
        m_system->viscosity = settings.viscosity;
        m_system->speedLimit = settings.speedLimit;
    }

    void particles(const Part& part)
    {
        for (const Particle& row : part.particles) {
            m_particle.emplace(row.id, int(m_system->key.size()));
            m_system->key.push_back(Key(row.id));
            m_system->mass.push_back(row.mass);
            m_system->inverseMass.push_back(row.pinned ? 0.0 : 1.0 / row.mass);
            m_system->start.position.push_back(row.position);
            m_system->start.velocity.push_back(row.pinned ? Vec3(Vec3::Zero()) : row.velocity);
        }
    }

    const Material& material(Id id) const
    {
        static const Material none;
        const Material* material = findItem<Material>(m_scene, id);
        return material ? *material : none;
    }

    void elements(const Part& part)
    {
        for (const Link& row : part.links) {
            const Material& stuff = material(row.material);
            const int a = m_particle.at(row.from);
            const int b = m_particle.at(row.to);
            const TearLimit tear{stuff.tearRule, row.tearLimit.value_or(stuff.tearLimit)};
            const bool spring = row.kind == LinkKind::Spring;
            m_link.emplace(row.id, int(m_system->links.size()));
            m_system->links.push_back(
                {Key(row.id), row.kind,
                 int(spring ? m_system->springs.size() : m_system->rods.size()), a, b});
            if (spring)
                m_system->springs.push_back(
                    {a, b, row.restLength, row.stiffness.value_or(stuff.stiffness),
                     row.damping.value_or(stuff.damping), row.resists, tear});
            else
                m_system->rods.push_back({a, b, row.restLength,
                                          row.compliance.value_or(stuff.compliance), row.resists,
                                          tear});
        }
        for (const Panel& row : part.panels) {
            const Material& stuff = material(row.material);
            m_panel.emplace(row.id, int(m_system->panels.size()));
            m_system->panels.push_back(
                {{m_particle.at(row.a), m_particle.at(row.b), m_particle.at(row.c)},
                 stuff.airLaw,
                 stuff.normalCoefficient,
                 stuff.skinFriction});
            m_system->panelKey.push_back(Key(row.id));
        }
    }

    void obstacle(const Collider& collider)
    {
        m_system->obstacles.push_back({collider.shape, collider.position,
                                       collider.normal.normalized(), collider.radius,
                                       collider.response, collider.restitution, collider.friction});
    }

    void input(Id id, const Control& control)
    {
        Input input{Key(id),
                    control.kind,
                    control.axis.normalized(),
                    control.limit,
                    control.rate,
                    control.automaticRate,
                    {}};
        for (const Id target : control.targets)
            input.targets.push_back(m_particle.at(target));
        m_system->inputs.push_back(std::move(input));
    }

    void shiftedRods()
    {
        std::vector<int> weights;
        for (const Input& input : m_system->inputs)
            if (input.kind == ControlKind::WeightShift)
                weights.insert(weights.end(), input.targets.begin(), input.targets.end());
        std::sort(weights.begin(), weights.end());
        weights.erase(std::unique(weights.begin(), weights.end()), weights.end());

        const auto& position = m_system->start.position;
        for (const int weight : weights)
            for (std::size_t r = 0; r < m_system->rods.size(); ++r) {
                const Rod& rod = m_system->rods[r];
                if (rod.a != weight && rod.b != weight)
                    continue;
                const int other = rod.a == weight ? rod.b : rod.a;
                m_system->shiftedRods.push_back(
                    {int(r), weight, position[std::size_t(other)] - position[std::size_t(weight)]});
            }
    }

    // Adds what an id stands for: an element itself, a part's or a group's elements.
    void collect(Id id, ProbeSpec& spec) const
    {
        if (const auto particle = m_particle.find(id); particle != m_particle.end())
            spec.particles.push_back(particle->second);
        else if (const auto link = m_link.find(id); link != m_link.end())
            spec.links.push_back(link->second);
        else if (const auto panel = m_panel.find(id); panel != m_panel.end())
            spec.panels.push_back(panel->second);
        else if (const Part* part = findItem<Part>(m_scene, id))
            collectPart(*part, spec);
        else if (const Group* group = findItem<Group>(m_scene, id))
            for (const Id member : group->members)
                collect(member, spec);
    }

    void collectPart(const Part& part, ProbeSpec& spec) const
    {
        for (const Particle& row : part.particles)
            spec.particles.push_back(m_particle.at(row.id));
        for (const Link& row : part.links)
            spec.links.push_back(m_link.at(row.id));
        for (const Panel& row : part.panels)
            spec.panels.push_back(m_panel.at(row.id));
    }

    void probe(Id id, const Probe& probe)
    {
        ProbeSpec spec{Key(id), probe.name, probe.quantity, {}, {}, {}, -1, probe.plotted};
        if (probe.target == noId)
            forEachPart(m_scene, [&](Id, const Part& part) { collectPart(part, spec); });
        else
            collect(probe.target, spec);
        if (probe.from != noId)
            spec.from = m_particle.at(probe.from);
        m_system->probes.push_back(std::move(spec));
    }

    const Scene& m_scene;
    std::shared_ptr<System> m_system = std::make_shared<System>();
    std::unordered_map<Id, int> m_particle;
    std::unordered_map<Id, int> m_link;
    std::unordered_map<Id, int> m_panel;
};

} // namespace

Result<std::shared_ptr<const System>> compile(const Scene& scene, std::uint64_t generation,
                                              std::uint64_t run)
{
    for (const Problem& problem : problemsOf(scene, 1))
        if (problem.severity == Severity::Error)
            return Failure{problem.message};
    return Compiler(scene).run(generation, run);
}

} // namespace ripstop
