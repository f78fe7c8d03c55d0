// A plane frame of spars, hung by its upper corners: c by r bays, braced or not.
//
// (c+1)(r+1) particles, c (r+1) + r (c+1) spars, and b braces in each bay. Bays without a brace
// give way like a hinged square; two rigidity particles, tied to every node, make any of them
// stiff.
#include "builders/designs.h"
#include "builders/network.h"

namespace ripstop {
namespace {

constexpr std::string_view braceNames[]{"none", "one", "crossed"};

// clang-format off
constexpr Parameter parameters[]{
    {"columns", "",     3,    1, 100, true,  "Bays across.", "Frame"},
    {"rows",    "",     2,    1, 100, true,  "Bays down."},
    {"width",   "m",    1.5,  0.01, 100, false, "From side to side."},
    {"height",  "m",    1.0,  0.01, 100, false, "From the upper to the lower edge."},
    {"braces",  "",     1,    0, 2,   true,  "Braces in each bay: 0 none, 1 one, leaning to and fro, 2 crossed.", {}, braceNames},
    {"rigidity", "",    0,    0, 1,   true,  "1 adds two rigidity particles, before and behind the frame, tied to every node."},
    {"density", "kg/m", 0.05, 1e-4, 50, false, "Mass of a spar or brace per length; a carbon tube of 6 mm has 0.02.", "Mass"},
    {"pinned",  "",     1,    0, 1,   true,  "1 holds the upper corners, 0 lets it fall to the ground."},
};
// clang-format on

Result<Scene> buildFrame(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Frame of spars";
    addGround(scene);
    Material material;
    material.name = "spar";
    material.color = "#20262e";
    material.linearDensity = p.at("density");
    const Id spar = addItem(scene, material);
    material.name = "brace";
    material.color = "#7d8597";
    const Id brace = addItem(scene, material);

    Network network(scene, "frame");
    const int columns = int(p.at("columns"));
    const int rows = int(p.at("rows"));
    const double width = p.at("width");
    const double height = p.at("height");
    std::vector<Id> nodes;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            nodes.push_back(network.particle({(double(column) / columns - 0.5) * width,
                                              (1.5 - double(row) / rows) * height, 0.0}));
    const auto at = [&](int row, int column) {
        return nodes[std::size_t(row * (columns + 1) + column)];
    };
    const auto tie = [&](Id from, Id to, Id kind) {
        network.rod(from, to, kind);
        const double mass = p.at("density") * network.part().links.back().restLength;
        network.row(from).mass += 0.5 * mass;
        network.row(to).mass += 0.5 * mass;
    };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column)
            tie(at(row, column), at(row, column + 1), spar);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column <= columns; ++column)
            tie(at(row, column), at(row + 1, column), spar);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const bool leansRight = (row + column) % 2 == 0;
            if (p.at("braces") == 2.0 || (p.at("braces") == 1.0 && leansRight))
                tie(at(row, column), at(row + 1, column + 1), brace);
            if (p.at("braces") == 2.0 || (p.at("braces") == 1.0 && !leansRight))
                tie(at(row, column + 1), at(row + 1, column), brace);
        }
    const double mass = network.row(nodes.front()).mass;
    std::vector<Id> hubs;
    if (p.at("rigidity") > 0.0) {
        material.name = "rigidity rods";
        material.shown = false;
        material.linearDensity.reset();
        const Id rigid = addItem(scene, material);
        for (const double side : {1.0, -1.0}) {
            hubs.push_back(network.particle({0.0, height, side * 0.5 * height}, mass));
            network.spokes(hubs.back(), nodes, rigid);
        }
    }
    const std::vector<Id> corners{at(0, 0), at(0, columns)};
    for (const Id corner : corners)
        network.row(corner).pinned = p.at("pinned") > 0.0;

    addGroup(scene, "upper corners", corners);
    addGroup(scene, "rigidity", hubs);
    const Id part = network.finish("frame", p);
    addProbe(scene, "lower corner", Quantity::PositionY, at(rows, columns));
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
    return scene;
}

} // namespace

const Builder frameBuilder{"frame",
                           "Frame of spars",
                           "Bays of spars in a plane, braced or stiffened by rigidity particles.",
                           parameters,
                           buildFrame,
                           Family::Lines};

} // namespace ripstop
