#include "scene/step_limits.h"

#include "base/step_limit.h"
#include "scene/bending.h"
#include "scene/link_stiffness.h"

#include <algorithm>
#include <limits>

namespace ripstop {

StepLimits stepLimitsOf(const Scene& scene, const ElementIndex& index)
{
    struct Sums
    {
        double stiffness = 0.0; // N/m
        double damping = 0.0;   // N s/m
        bool forces = false;
    };
    std::vector<Sums> at;
    forEachPart(scene, [&](Id, const Part& part) { at.resize(at.size() + part.particles.size()); });
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links) {
            if (link.kind != LinkKind::Spring)
                continue;
            const int place = index.material(link.material);
            const Material* material =
                place < 0 ? nullptr : &std::get<Material>(scene.items[std::size_t(place)].item);
            for (const Id end : {link.from, link.to}) {
                const int particle = index.particle(end);
                if (particle < 0)
                    continue;
                Sums& sums = at[std::size_t(particle)];
                sums.stiffness += link.stiffness.value_or(
                    material ? springStiffness(*material, link.role, link.width, link.restLength)
                             : 0.0);
                sums.damping += link.damping.value_or(material ? material->damping : 0.0);
                sums.forces = true;
            }
        }
    });
    const std::vector<double> bends = bendSumsOf(scene, index);
    for (std::size_t k = 0; k < bends.size(); ++k) {
        at[k].stiffness += bends[k];
        at[k].forces |= bends[k] > 0.0;
    }
    StepLimits limits;
    limits.bends = std::ranges::any_of(bends, [](double sum) { return sum > 0.0; });
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const Sums& sums = at[limits.timeStep.size()];
            limits.timeStep.push_back(particle.pinned || !sums.forces
                                          ? std::numeric_limits<double>::infinity()
                                          : springStepLimit(particle.mass, sums.stiffness,
                                                            sums.damping,
                                                            scene.settings.integrator));
        }
    });
    return limits;
}

} // namespace ripstop
