#include "tools/hand_settings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ripstop {
namespace {

constexpr double standardGravity = 9.80665; // m/s^2
constexpr double leastForce = 5.0;          // N
constexpr double leastSize = 0.1;           // m

// Two digits are enough for a number that was found.
double rounded(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return decade * std::round(value / decade);
}

// Bounds of the fabric, or of all particles where there is none: a kite is not as large as its line
// is long.
Eigen::AlignedBox3d bounds(const Scene& scene)
{
    std::vector<bool> isCorner(std::size_t(scene.nextId), false); // by id
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Panel& panel : part.panels)
            for (const Id corner : {panel.a, panel.b, panel.c})
                if (corner < scene.nextId)
                    isCorner[std::size_t(corner)] = true;
    });
    Eigen::AlignedBox3d all, fabric;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            all.extend(particle.position);
            if (particle.id < scene.nextId && isCorner[std::size_t(particle.id)])
                fabric.extend(particle.position);
        }
    });
    return fabric.isEmpty() ? all : fabric;
}

} // namespace

double HandSettings::mostIn(const Scene& scene) const
{
    if (most)
        return *most;
    double mass = 0.0; // kg
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            mass += particle.pinned ? 0.0 : particle.mass;
    });
    return rounded(std::max(5.0 * standardGravity * mass, leastForce));
}

double HandSettings::stiffnessIn(const Scene& scene) const
{
    if (stiffness)
        return *stiffness;
    const Eigen::AlignedBox3d box = bounds(scene);
    const double size = box.isEmpty() ? 1.0 : std::max(box.diagonal().norm(), leastSize);
    return rounded(mostIn(scene) / (0.2 * size));
}

} // namespace ripstop
