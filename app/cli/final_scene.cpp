#include "cli/final_scene.h"

#include "scene/edit.h"

#include <unordered_map>

namespace ripstop {

Scene finalScene(Scene scene, const Simulation& simulation)
{
    const std::shared_ptr<const Frame> frame = simulation.frame();
    const Layout& layout = *frame->layout;

    std::unordered_map<Id, std::size_t> index;
    for (std::size_t i = 0; i < layout.particleId.size(); ++i)
        index.emplace(Id{layout.particleId[i]}, i);
    SetValues positions{findProperty(Kind::Particle, "position"), {}, {}};
    SetValues velocities{findProperty(Kind::Particle, "velocity"), {}, {}};
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const auto found = index.find(particle.id);
            if (found == index.end())
                continue;
            positions.targets.push_back(particle.id);
            positions.values.emplace_back(frame->position[found->second]);
            velocities.targets.push_back(particle.id);
            velocities.values.emplace_back(frame->velocity[found->second]);
        }
    });

    std::vector<Id> gone;
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (frame->torn[i])
            gone.push_back(Id{layout.links[i].id});
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        if (frame->gone[i])
            gone.push_back(Id{layout.panelId[i]});

    if (!positions.targets.empty())
        (void)apply(scene, {"Adopt pose", {std::move(positions), std::move(velocities)}});
    (void)apply(scene, removal(scene, gone));
    return scene;
}

} // namespace ripstop
