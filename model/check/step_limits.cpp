// Sums of springs and of bending at each particle, and the limits that they give. Whether springs
// are solved together with rods is found first, since those are left out of the sums.
#include "check/step_limits.h"

#include "derived/bending.h"
#include "derived/link_stiffness.h"
#include "derived/material_of.h"
#include "laws/step_limit.h"

#include <algorithm>
#include <limits>

namespace ripstop {

namespace {

struct Sums // of the forces at a particle
{
    double stiffness = 0.0; // N/m
    double damping = 0.0;   // N s/m

    double limit(const Particle& particle, Integrator integrator) const
    {
        return particle.pinned ? std::numeric_limits<double>::infinity()
                               : springStepLimit(particle.mass, stiffness, damping, integrator);
    }
};

template <typename Visit> // visit(link)
void forEachSpring(const Scene& scene, Visit visit)
{
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links)
            if (link.kind == LinkKind::Spring)
                visit(link);
    });
}

bool hasRods(const Scene& scene)
{
    bool found = false;
    forEachPart(scene, [&](Id, const Part& part) {
        found |=
            std::ranges::any_of(part.links, [](const Link& l) { return l.kind == LinkKind::Rod; });
    });
    return found;
}

// Whether the solver and the integrator may solve springs together with rods.
bool mayBeTogether(const Settings& settings)
{
    return settings.solver == Solver::Auto
               ? settings.integrator == Integrator::Auto || isImplicit(settings.integrator)
               : settings.solver == Solver::Direct
                     && settings.integrator == Integrator::ImplicitEuler;
}

// s, where bdf2 may come into it that of bdf2.
double longestSubstep(const Scene& scene)
{
    const Settings& settings = scene.settings;
    const bool mayBeLong = settings.integrator == Integrator::Auto && hasRods(scene);
    return settings.timeStep
           / (mayBeLong ? (settings.substeps + substepsOfEuler - 1) / substepsOfEuler
                        : settings.substeps);
}

SpringNumbers numbersOf(const Scene& scene, const ElementIndex& index, const Link& link)
{
    return springNumbers(link, materialOf(scene, index, link.material));
}

std::vector<Sums> sumsOfSprings(const Scene& scene, const ElementIndex& index, bool onlyDampers)
{
    std::size_t particles = 0;
    forEachPart(scene, [&](Id, const Part& part) { particles += part.particles.size(); });
    std::vector<Sums> at(particles);
    forEachSpring(scene, [&](const Link& link) {
        const auto [stiffness, damping] = numbersOf(scene, index, link);
        if (onlyDampers && stiffness > 0.0)
            return;
        for (const Id end : {link.from, link.to})
            if (const int particle = index.particle(end); particle >= 0) {
                at[std::size_t(particle)].stiffness += stiffness;
                at[std::size_t(particle)].damping += damping;
            }
    });
    return at;
}

} // namespace

Message StepLimitCause::said() const
{
    if (springs && bending)
        return Message("springs and bending");
    return springs ? Message("springs") : bending ? Message("bending") : Message();
}

SpringNumbers springNumbers(const Link& link, const Material& material)
{
    return {link.stiffness.value_or(springStiffness(material, link)),
            link.damping.value_or(material.damping)};
}

bool springsAreTogether(const Scene& scene, const ElementIndex& index)
{
    const Settings& settings = scene.settings;
    if (!mayBeTogether(settings))
        return false;
    const std::vector<Sums> springs = sumsOfSprings(scene, index, false);
    const bool some = std::ranges::any_of(springs, [](const Sums& s) { return s.stiffness > 0.0; });
    if (!some || settings.integrator == Integrator::ImplicitEuler)
        return some;
    const double longest = spareOfSubsteps * longestSubstep(scene);
    const bool isBdf2 = longest > spareOfSubsteps * settings.timeStep / settings.substeps;
    const Integrator integrator = isBdf2 ? Integrator::Bdf2 : settings.integrator;
    bool tooStiff = false;
    std::size_t next = 0;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            tooStiff |= springs[next++].limit(particle, integrator) < longest;
    });
    return tooStiff;
}

StepLimits stepLimitsOf(const Scene& scene, const ElementIndex& index)
{
    StepLimits limits;
    limits.springsTogether = springsAreTogether(scene, index);
    std::vector<Sums> at = sumsOfSprings(scene, index, limits.springsTogether);
    limits.cause.springs =
        std::ranges::any_of(at, [](const Sums& s) { return s.stiffness > 0.0 || s.damping > 0.0; });
    const auto isRod = [&](const Link& link) {
        return link.kind == LinkKind::Rod
               || (limits.springsTogether && numbersOf(scene, index, link).stiffness > 0.0);
    };
    const std::vector<double> bends = bendSumsOf(scene, index, isRod);
    for (std::size_t k = 0; k < bends.size(); ++k)
        at[k].stiffness += bends[k];
    limits.cause.bending = std::ranges::any_of(bends, [](double sum) { return sum > 0.0; });
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            limits.timeStep.push_back(
                at[limits.timeStep.size()].limit(particle, scene.settings.integrator));
    });
    return limits;
}

} // namespace ripstop
