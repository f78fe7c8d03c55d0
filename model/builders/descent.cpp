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
    force((wanted - alone) / each); // the cloth keeps the last one that is set
}

CanopyMaterials addCanopyMaterials(Scene& scene, const std::map<std::string, double>& parameters,
                                   Material cloth, const std::array<const char*, 2>& names,
                                   const std::array<const char*, 2>& colors)
{
    Material material = std::move(cloth);
    material.skinFriction = parameters.at("friction");
    const auto add = [&](const char* name, const char* color, bool shown) {
        material.name = name;
        material.color = color;
        material.shown = shown;
        return addItem(scene, material);
    };
    CanopyMaterials materials{};
    materials.cloth = {add(names[0], colors[0], true), add(names[1], colors[1], true)};
    material.porosity = 0.0; // of cloth alone
    materials.seams = add("seams", "#b5b2a6", true);
    material.diameter = parameters.at("line_diameter");
    materials.lines = add("suspension line", "#4f5d75", true);
    material.diameter = 0.0;
    materials.frame = add("frame", "#8d99ae", false);
    return materials;
}

std::vector<Id> addHoop(Network& network, const std::vector<Id>& skirt, double reach, double mass,
                        Id material, bool isTied)
{
    const double height = network.position(skirt.front()).y();
    std::vector<Id> hubs;
    for (const double side : {1.0, -1.0}) {
        hubs.push_back(network.particle({0.0, height + side * reach, 0.0}, 0.5 * mass));
        network.spokes(hubs.back(), skirt, material);
    }
    if (isTied)
        network.rod(hubs[0], hubs[1], material);
    return hubs;
}

} // namespace ripstop
