// Patches are laid on a mesh that has its panels and weighed there; their numbers follow when
// makeOf() gives those of the cloth below.
#include "builders/reinforcement.h"

#include "materials/presets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace ripstop {
namespace {

constexpr const char* patchColor = "#6d597a";

double nearestTo(const Network& network, const std::vector<Id>& points, const Panel& panel)
{
    const Vec3 middle =
        (network.position(panel.a) + network.position(panel.b) + network.position(panel.c)) / 3.0;
    double nearest = 1e9; // m
    for (const Id point : points)
        nearest = std::min(nearest, (network.position(point) - middle).norm());
    return nearest;
}

// The material below a patch on cloth of this material, made at its first panel.
Id coveredOf(Id cloth, std::map<Id, Id>& covered, Scene& scene)
{
    const auto found = covered.find(cloth);
    if (found != covered.end())
        return found->second;
    Material material = std::get<Material>(*findItem(scene, cloth));
    material.name += " patch";
    material.color = patchColor;
    return covered[cloth] = addItem(scene, material);
}

// N/m, that both layers bear together; unknown where that of one is.
std::optional<double> strengthOf(double lower, std::optional<double> lowerBears, double upper,
                                 std::optional<double> upperBears)
{
    if (!lowerBears || !upperBears)
        return std::nullopt;
    return (lower + upper) * std::min(*lowerBears / lower, *upperBears / upper);
}

// Air that goes through both layers loses the pressure of each: c^-2 = c1^-2 + c2^-2.
double porosityOf(double lower, double upper)
{
    return lower > 0.0 && upper > 0.0 ? lower * upper / std::hypot(lower, upper) : 0.0;
}

} // namespace

Result<std::vector<Id>> addPatches(const Parameters& p, const std::vector<Id>& points, Scene& scene,
                                   Network& network, const CraftChoices& choices)
{
    const Preset* patch = patchOf(p, choices);
    if (!patch || isIdeal(p, "cloth"))
        return std::vector<Id>{};
    const double radius = p.at("patch_radius");
    double nearest = 1e9; // m
    std::map<Id, Id> covered;
    for (Panel& panel : network.panels()) {
        const double away = nearestTo(network, points, panel);
        nearest = std::min(nearest, away);
        if (away <= radius)
            panel.material = coveredOf(panel.material, covered, scene);
    }
    if (covered.empty())
        return Failure{"patch_radius: patches of %1 m cover no panel of this mesh; it takes %2 m, "
                       "or a finer mesh.",
                       Message::number("%g", radius),
                       Message::number("%.3f", std::ceil(1e3 * nearest) * 1e-3)};
    Material numbers;
    give(numbers, *patch);
    std::vector<Id> materials;
    for (const auto& [cloth, material] : covered) {
        network.addFabricMass(*numbers.arealDensity, material);
        materials.push_back(material);
    }
    return materials;
}

void addLayer(Material& cloth, const Material& patch)
{
    const double warp = *cloth.membraneStiffness, weft = cloth.weftStiffness.value_or(warp);
    const double patchWarp = *patch.membraneStiffness;
    const double patchWeft = patch.weftStiffness.value_or(patchWarp);
    cloth.warpStrength = strengthOf(warp, cloth.warpStrength, patchWarp, patch.warpStrength);
    cloth.weftStrength = strengthOf(weft, cloth.weftStrength, patchWeft, patch.weftStrength);
    cloth.membraneStiffness = warp + patchWarp;
    cloth.weftStiffness = weft + patchWeft;
    cloth.shearStiffness = cloth.shearStiffness.value_or(0.0) + patch.shearStiffness.value_or(0.0);
    cloth.bendingStiffness += patch.bendingStiffness; // they slide on each other between stitches
    cloth.arealDensity = cloth.arealDensity.value_or(0.0) + patch.arealDensity.value_or(0.0);
    cloth.porosity = porosityOf(cloth.porosity, patch.porosity);
    if (cloth.tearStrength && patch.tearStrength) // a tear cuts the yarns of both
        cloth.tearStrength = *cloth.tearStrength + *patch.tearStrength;
    else
        cloth.tearStrength = std::nullopt;
}

} // namespace ripstop
