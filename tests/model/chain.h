// A line, a spar or a strut of a material that a test makes up, for tests of what it bears and when
// it breaks.
#pragma once

#include "compile/compile.h"
#include "scene/scene.h"
#include "simulation/simulation.h"

#include <QtGlobal>

#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

// Particles along a way, each linked with the next; the first `pinned` of them hold still.
struct Chain
{
    Scene scene;
    Id part{};
    Id material{};

    Chain(const std::vector<Vec3>& places, int pinned, double mass, const Material& made,
          const Link& like = {})
    {
        material = takeId(scene);
        scene.items.push_back({material, made});
        part = takeId(scene);
        Part row;
        for (std::size_t i = 0; i < places.size(); ++i)
            row.particles.push_back({.id = takeId(scene),
                                     .position = places[i],
                                     .mass = mass,
                                     .pinned = int(i) < pinned});
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            Link link = like;
            link.id = takeId(scene);
            link.from = row.particles[i].id;
            link.to = row.particles[i + 1].id;
            link.material = material;
            link.kind = LinkKind::Rod;
            link.restLength = (places[i + 1] - places[i]).norm();
            row.links.push_back(link);
        }
        scene.items.push_back({part, row});
        scene.settings.airDensity = 0.0;
        scene.settings.viscosity = 20.0;
    }

    Part& row() { return std::get<Part>(scene.items[1].item); }
    Material& stuff() { return std::get<Material>(scene.items[0].item); }

    std::shared_ptr<const Frame> after(double seconds) const
    {
        const auto system = compile(scene);
        if (!system)
            qFatal("%s", system.message().english().c_str());
        Simulation simulation(*system);
        simulation.runUntil(seconds);
        return simulation.frame();
    }
};

inline Material line(std::optional<double> strength)
{
    Material material;
    material.axialStiffness = 1e4;
    material.dampingTime = 0.02;
    material.lineStrength = strength;
    return material;
}

} // namespace ripstop
