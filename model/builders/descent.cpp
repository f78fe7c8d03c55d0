#include "builders/descent.h"

#include "builders/statics.h"

namespace ripstop {

void setDrag(Scene& scene, const Network& network, std::span<const Id> cloth, double coefficient,
             double area)
{
    const double wanted = 0.5 * scene.settings.airDensity * coefficient * area; // N at 1 m/s
    const auto force = [&](double normal) {
        for (const Id id : cloth)
            std::get<Material>(*findItem(scene, id)).normalCoefficient = normal;
        return airLoad(scene, network.part(), Vec3::UnitY()).force.y();
    };
    const double alone = force(0.0);
    const double each = force(1.0) - alone;
    force((wanted - alone) / each); // and leaves it at that
}

std::vector<Id> addHoop(Network& network, const std::vector<Id>& skirt, double reach, double mass,
                        Id material)
{
    const double height = network.position(skirt.front()).y();
    std::vector<Id> hubs;
    for (const double side : {1.0, -1.0}) {
        hubs.push_back(network.particle({0.0, height + side * reach, 0.0}, 0.5 * mass));
        network.spokes(hubs.back(), skirt, material);
    }
    return hubs;
}

} // namespace ripstop
