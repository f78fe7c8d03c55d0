#include "compile/compile.h"

#include "compile/resolve.h"
#include "scene/check.h"

namespace ripstop {
namespace {

struct Counts
{
    std::size_t particles = 0;
    std::size_t springs = 0;
    std::size_t rods = 0;
    std::size_t panels = 0;
};

Counts countsOf(const Scene& scene)
{
    Counts counts;
    forEachPart(scene, [&](Id, const Part& part) {
        counts.particles += part.particles.size();
        counts.panels += part.panels.size();
        for (const Link& row : part.links)
            ++(row.kind == LinkKind::Spring ? counts.springs : counts.rods);
    });
    return counts;
}

void reserve(const Counts& counts, System& system)
{
    system.key.reserve(counts.particles);
    system.mass.reserve(counts.particles);
    system.inverseMass.reserve(counts.particles);
    system.start.position.reserve(counts.particles);
    system.start.velocity.reserve(counts.particles);
    system.springs.reserve(counts.springs);
    system.rods.reserve(counts.rods);
    system.links.reserve(counts.springs + counts.rods);
    system.linkStuff.reserve(counts.springs + counts.rods);
    system.panels.reserve(counts.panels);
    system.panelKey.reserve(counts.panels);
    system.panelMaterial.reserve(counts.panels);
}

void addParticles(const Part& part, System& system)
{
    for (const Particle& row : part.particles) {
        const ParticleValues values = valuesOf(row);
        system.key.push_back(Key(row.id));
        system.mass.push_back(values.mass);
        system.inverseMass.push_back(values.inverseMass);
        system.start.position.push_back(values.position);
        system.start.velocity.push_back(values.velocity);
    }
}

void addElements(const Scene& scene, const ElementIndex& index, const Part& part, System& system)
{
    for (const Link& row : part.links) {
        const Material& material = materialOf(scene, index, row.material);
        const int a = index.particle(row.from);
        const int b = index.particle(row.to);
        const bool spring = row.kind == LinkKind::Spring;
        system.links.push_back({Key(row.id), row.kind,
                                int(spring ? system.springs.size() : system.rods.size()), a, b});
        system.linkStuff.push_back(stuffOf(row));
        if (spring)
            system.springs.push_back(springOf(row, material, a, b));
        else
            system.rods.push_back(rodOf(row, material, a, b));
    }
    for (const Panel& row : part.panels) {
        const Material& material = materialOf(scene, index, row.material);
        system.panels.push_back(panelOf(
            material, {index.particle(row.a), index.particle(row.b), index.particle(row.c)}));
        system.panelKey.push_back(Key(row.id));
        system.panelMaterial.push_back(Key(row.material));
    }
}

} // namespace

std::shared_ptr<const System> compileSound(const Scene& scene, const ElementIndex& index,
                                           std::uint64_t generation, std::uint64_t run)
{
    auto system = std::make_shared<System>();
    system->generation = generation;
    system->run = run;
    takeSettings(scene.settings, *system);
    reserve(countsOf(scene), *system);
    forEachPart(scene, [&](Id, const Part& part) { addParticles(part, *system); });
    forEachPart(scene, [&](Id, const Part& part) { addElements(scene, index, part, *system); });
    system->wind = totalWind(scene);
    system->obstacles = obstaclesOf(scene);
    system->inputs = inputsOf(scene, index);
    system->probes = probesOf(scene, index);
    finish(*system);
    system->shiftedRods = shiftedRodsOf(*system);
    return system;
}

Result<std::shared_ptr<const System>> compile(const Scene& scene, std::uint64_t generation,
                                              std::uint64_t run)
{
    const ElementIndex index(scene);
    if (const std::optional<Problem> error = firstError(scene, index))
        return Failure{error->message};
    return compileSound(scene, index, generation, run);
}

} // namespace ripstop
