// The papers' smallest example of rigidity particles: a row of four particles kept straight by two
// more that are tied to all of them. 6 particles, 3 + 2 x 4 = 11 rods; 9 would do in the plane.
#include "builders/designs.h"
#include "builders/network.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr Parameter parameters[]{
    {"length", "m",  1.5,  0.01, 100, false, "From end to end."},
    {"height", "m",  0.5,  0.01, 100, false, "How far the rigidity particles stand off the rod; near ones stiffen less."},
    {"mass",   "kg", 0.6,  1e-4, 1e4, false, "Of all six particles together."},
    {"pinned", "",   1,    0, 1,     true,  "1 holds one end so that the rod swings, 0 lets it fall to the ground."},
};
// clang-format on

Result<Scene> buildStiffenedRod(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Stiffened rod";
    scene.settings.notes = "Four particles in a row stay straight because two rigidity particles "
                           "are tied to each of them. Remove one of the two and watch it fold.";
    addGround(scene);
    Material material;
    material.name = "bar";
    material.color = "#c8553d";
    const Id bar = addItem(scene, material);
    material.name = "frame";
    material.color = "#8d99ae";
    const Id frame = addItem(scene, material);

    Network network(scene, "rod");
    const double length = p.at("length");
    // Half a length stays free over the ground, whichever way it swings.
    const double reach = std::max(length, std::hypot(0.5 * length, p.at("height")));
    const double level = 0.5 * length + reach;
    const double each = p.at("mass") / 6.0;
    std::vector<Id> row;
    for (int i = 0; i < 4; ++i)
        row.push_back(network.particle({length * i / 3.0, level, 0.0}, each));
    for (int i = 0; i < 3; ++i)
        network.rod(row[i], row[i + 1], bar);
    std::vector<Id> stiffeners;
    for (const double side : {1.0, -1.0}) {
        const Vec3 place(0.5 * length, level + side * p.at("height"), 0.0);
        stiffeners.push_back(network.particle(place, each));
        network.spokes(stiffeners.back(), row, frame);
    }
    network.row(row.front()).pinned = p.at("pinned") > 0.0;

    addGroup(scene, "row", row);
    addGroup(scene, "rigidity", stiffeners);
    const Id part = network.finish("stiffened_rod", p);
    addProbe(scene, "end height", Quantity::PositionY, row.back());
    addProbe(scene, "end to end", Quantity::Distance, row.back(), row.front());
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
    return scene;
}

} // namespace

const Builder stiffenedRodBuilder{
    "stiffened_rod", "Stiffened rod",   "Four particles in a row, kept straight by two more.",
    parameters,      buildStiffenedRod, Family::Lines};

} // namespace ripstop
