// A rope or chain: a row of particles, hung by one end or by both.
//
// Rods between second neighbours cut the stretch that the solver leaves to about a third and make
// the rope resist folding; doubling rods side by side, as the paper has it, changes nothing.
#include "builders/craft_materials.h"
#include "builders/designs.h"
#include "builders/network.h"
#include "builders/statics.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr CraftChoices ropeChoices{{}, {}, cordChoices};
constexpr ParameterNeed ofNumbers = isZero("cord");

// clang-format off
constexpr Parameter parameters[]{
    {"segments",  "",     20,   1, 5000, true,  "Rods from end to end.", "Rope"},
    {"length",    "m",    2,    0.01, 1000, false, "Of the whole rope."},
    {"cord",      "",     0,    0, cordChoices.size() - 1, true, "What the rope is made of; an ideal one is as stiff and heavy as said below.", {}, cordChoices, 7},
    {"density",   "kg/m", 0.05, 0, 50,   false, "Mass of the rope per length.", {}, {}, {}, ofNumbers},
    {"axial",     "N",    0,    0, 1e9,  false, "Axial stiffness EA of the rope, its tension per strain; 0 never stretches.", {}, {}, {}, ofNumbers},
    {"rigidity",  "N m^2", 0,   0, 1e6,  false, "Flexural rigidity EI of a spar, its bending moment per curvature; a kite spar has 1 to 10, a rope nothing.", {}, {}, {}, ofNumbers},
    {"clamped",   "",     0,    0, 1,    true,  "1 pins the second particle as well, so that the first segment keeps its direction."},
    {"end_mass",  "kg",   0,    0, 1000, false, "A bob at the free end, over and above the rope's own mass.", "Set-up"},
    {"angle",     "deg",  60,   0, 180,  false, "Of the rope at the start, from straight down."},
    {"ends",      "",     1,    0, 2,    true,  "How many ends are pinned."},
    {"stiffened", "",     0,    0, 1,    true,  "1 adds rods between second neighbours.", {}, {}, {}, ofNumbers},
    {"one_sided", "",     1,    0, 1,    true,  "1 resists tension only like a rope, 0 compression too like a chain of sticks."},
};
// clang-format on

Result<Scene> buildRope(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Rope";
    addGround(scene);
    const bool isOfNumbers = isIdeal(p, "cord");
    const double density = cordDensity(p, ropeChoices, "density"); // kg/m
    Material material;
    material.name = "cord";
    material.color = "#b08968";
    material.linearDensity = density;
    if (isOfNumbers && p.at("axial") > 0.0)
        material.axialStiffness = p.at("axial");
    material.flexuralRigidity = isOfNumbers ? p.at("rigidity") : 0.0;
    const Id cord = addItem(scene, material);
    Network network(scene, "rope");
    const int count = int(p.at("segments"));
    const double length = p.at("length");
    const double angle = p.at("angle") * degrees;
    const Vec3 top(0.0, 1.25 * length, 0.0);
    const Id first = network.particle(top);
    const Id last = network.particle(top + length * Vec3(std::sin(angle), -std::cos(angle), 0.0));
    const Resists resists = p.at("one_sided") > 0.0 ? Resists::Tension : Resists::Both;
    const std::vector<Id> nodes = network.line(first, last, count, length * density, cord, resists);
    if (isOfNumbers && p.at("stiffened") > 0.0) {
        material.name = "stiffening";
        material.flexuralRigidity = 0.0;
        material.shown = false;
        const Id stiffening = addItem(scene, material);
        for (int i = 0; i + 2 <= count; ++i)
            network.rod(nodes[i], nodes[i + 2], stiffening, resists);
    }
    CraftMaterials made;
    made.lines = {cord};
    makeOf(p, made, scene, network, ropeChoices);
    network.row(last).mass += p.at("end_mass");
    for (const Id node : nodes) // a rope without mass is a bob on a string
        network.row(node).mass = std::max(network.row(node).mass, 1e-6);
    network.row(first).pinned = p.at("ends") >= 1.0;
    network.row(last).pinned = p.at("ends") >= 2.0;
    network.row(nodes[1]).pinned |= p.at("clamped") > 0.0;

    addGroup(scene, "rope nodes", nodes);
    const Id firstRod = network.part().links.front().id;
    const Id part = network.finish("rope", p);
    addProbe(scene, "end height", Quantity::PositionY, last);
    addProbe(scene, "end speed", Quantity::Speed, last);
    addProbe(scene, "distance", Quantity::Distance, last, first);
    addProbe(scene, "tension", Quantity::Tension, firstRod);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
    addProbe(scene, "energy", Quantity::TotalEnergy);
    if (isOfNumbers && p.at("rigidity") > 0.0)
        takeShortSubsteps(scene);
    return scene;
}

} // namespace

const Builder ropeBuilder{"rope",     "Rope",    "A row of rods, hung by one end or by both.",
                          parameters, buildRope, Family::Lines};

} // namespace ripstop
