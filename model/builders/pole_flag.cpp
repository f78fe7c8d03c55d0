// A flag on a pole: a sheet of springs, tied along its hoist to a pole that may bend.
//
// The pole stands on the ground, clamped: its lowest two particles are pinned. It is a row of rods
// with the flexural rigidity EI of a spar, or rigid, with every particle pinned. The flag is tied
// to it by short lines, at its two corners or at every row. With c by r cells and l segments of the
// pole below the flag: (c+1)(r+1) + r + l + 1 particles, 2 c r panels. A cloth of the library is
// carried by these panels in place of springs, with a hem of rods all around (craft_materials.h).
#include "builders/craft_materials.h"
#include "builders/designs.h"
#include "builders/network.h"
#include "builders/statics.h"
#include "derived/link_stiffness.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::string_view ties[]{"corners", "every_row"};
constexpr CraftChoices flagChoices{clothChoices, {}, {}};
constexpr ParameterNeed ofSprings = isZero("cloth");

// clang-format off
constexpr Parameter parameters[]{
    {"columns",   "",       18,   1, 200,  true,  "Cells from the pole to the free edge.", "Mesh"},
    {"rows",      "",       12,   2, 200,  true,  "Cells from the upper to the lower edge."},
    {"length",    "m",      1.2,  0.05, 20, false, "From the pole to the free edge.", "Flag"},
    {"height",    "m",      0.8,  0.05, 20, false, "Along the pole."},
    {"cloth",     "",       0,    0, clothChoices.size() - 1, true, "Cloth of the flag; ideal cloth is a sheet of springs, as stiff and heavy as said below, a real one is carried by panels and wrinkles.", {}, clothChoices, 2},
    {"density",   "kg/m^2", 0.11, 0.005, 10, false, "Mass of the fabric per area; 0.11 is knitted polyester for flags.", {}, {}, {}, ofSprings},
    {"stiffness", "N/m",    200,  1, 1e5,  false, "Of structural springs: the tension of the fabric per strain.", {}, {}, {}, ofSprings},
    {"shear",     "",       0.3,  0, 2,    false, "Stiffness of shear springs over that of structural ones.", {}, {}, {}, ofSprings},
    {"tied",      "",       1,    0, 1,    true,  "Where the hoist is tied to the pole.", {}, ties},
    {"pole",      "m",      2.5,  0.1, 50, false, "Height of the pole; at least that of the flag and a little.", "Pole"},
    {"rigidity",  "N m^2",  0,    0, 1e5,  false, "Flexural rigidity EI of the pole; 0 does not bend, a fibre glass rod of 12 mm has 40."},
    {"pole_density", "kg/m", 0.2, 0.001, 50, false, "Mass of the pole per length."},
    {"wind",      "m/s",    8,    0, 40,   false, "Speed of the wind.", "Air"},
    {"gusts",     "m/s",    0,    0, 50,   false, "Wind at 20 ft whose gusts blow as well; 7.7 is light turbulence, 15.4 moderate."},
};
// clang-format on

constexpr double gap = 0.02; // m, between hoist and pole

struct Materials
{
    Id cloth;
    Id structural;
    Id shear;
    Id pole;
    Id ties;
};

Materials addMaterials(Scene& scene, const Parameters& p)
{
    Material material;
    material.damping = 0.01;
    material.arealDensity = p.at("density");
    const auto add = [&](const char* name, const char* color, double stiffness, bool shown) {
        material.name = name;
        material.color = color;
        material.stiffness = stiffness;
        material.shown = shown;
        return addItem(scene, material);
    };
    Materials materials{};
    materials.cloth =
        add("cloth", "#c1121f", isIdeal(p, "cloth") ? p.at("stiffness") : material.stiffness, true);
    materials.structural = add("structural", "#9d0f1a", p.at("stiffness"), true);
    materials.shear = add("shear", "#e07a7f", p.at("shear") * p.at("stiffness"), false);
    material = Material{};
    materials.ties = add("ties", "#f4f1de", material.stiffness, true);
    material.linearDensity = p.at("pole_density");
    material.flexuralRigidity = p.at("rigidity");
    materials.pole = add("pole", "#6c757d", material.stiffness, true);
    return materials;
}

// From the ground up; the uppermost nodes stand beside the rows of the flag.
std::vector<Id> addPole(Network& network, const Parameters& p, Id material)
{
    const int rows = int(p.at("rows"));
    const double height = p.at("height");
    const double below = std::max(p.at("pole") - height, 0.1 * height); // m
    const int segments = std::max(1, int(std::lround(below * rows / height)));
    std::vector<Id> nodes;
    for (int i = 0; i < segments; ++i)
        nodes.push_back(network.particle({0.0, below * i / segments, 0.0}));
    for (int i = 0; i <= rows; ++i)
        nodes.push_back(network.particle({0.0, below + height * i / rows, 0.0}));
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        network.rod(nodes[i - 1], nodes[i], material);
        const double mass = p.at("pole_density") * network.part().links.back().restLength;
        network.row(nodes[i - 1]).mass += 0.5 * mass;
        network.row(nodes[i]).mass += 0.5 * mass;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
        network.row(nodes[i]).pinned = i < 2 || p.at("rigidity") <= 0.0;
    return nodes;
}

// Row by row from below, each from the hoist to the fly.
std::vector<std::vector<Id>> addFlag(Network& network, const Parameters& p,
                                     const Materials& materials, double lower)
{
    const int columns = int(p.at("columns"));
    const int rows = int(p.at("rows"));
    const double width = p.at("length") / columns;
    const double height = p.at("height") / rows;
    std::vector<std::vector<Id>> nodes;
    for (int row = 0; row <= rows; ++row) {
        nodes.emplace_back();
        for (int column = 0; column <= columns; ++column) {
            const double u = double(column) / columns;
            const Id node = network.particle({gap + u * p.at("length"), lower + row * height, 0.0});
            network.texture(node, u, double(row) / rows);
            // a flag that is exactly plane in the wind would stay so for ever
            network.row(node).velocity.z() = 0.3 * u * std::sin(2.0 * pi * u);
            nodes.back().push_back(node);
        }
    }
    const auto at = [&](int row, int column) {
        return nodes[std::size_t(row)][std::size_t(column)];
    };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column) {
            network.spring(at(row, column), at(row, column + 1), materials.structural);
            network.asFabric({LinkRole::Thread, row == 0 || row == rows ? 0.5 * height : height,
                              aspectOfCells(width, height)});
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            network.spring(at(row, column), at(row + 1, column), materials.structural);
            network.asFabric({LinkRole::Thread,
                              column == 0 || column == columns ? 0.5 * width : width,
                              aspectOfCells(height, width)});
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Id a = at(row, column), b = at(row, column + 1);
            const Id c = at(row + 1, column), d = at(row + 1, column + 1);
            for (const auto& [from, to] : {std::pair(a, d), std::pair(b, c)}) {
                network.spring(from, to, materials.shear);
                network.asFabric({LinkRole::Bias, biasWidth(width, height)});
            }
            const bool leansRight = (row + column) % 2 == 0; // no grain
            network.panel(a, b, leansRight ? d : c, materials.cloth);
            network.panel(leansRight ? a : b, d, c, materials.cloth);
        }
    return nodes;
}

// All around, as stiff either way as those of kites: between its nodes it does not fold. Returns
// its material.
Id addHem(Scene& scene, Network& network, const std::vector<std::vector<Id>>& nodes, double density)
{
    Material hem;
    hem.name = "hem";
    hem.color = "#9d0f1a";
    const Id material = addItem(scene, hem);
    const auto sew = [&](Id from, Id to) { network.rod(from, to, material); };
    for (std::size_t row = 1; row < nodes.size(); ++row) {
        sew(nodes[row - 1].front(), nodes[row].front());
        sew(nodes[row - 1].back(), nodes[row].back());
    }
    for (const auto& row : {nodes.front(), nodes.back()})
        for (std::size_t column = 1; column < row.size(); ++column)
            sew(row[column - 1], row[column]);
    network.addLinkMass(material, density);
    return material;
}

Result<Scene> buildPoleFlag(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Flag on a pole";
    addGround(scene);
    addWind(scene, p.at("wind") * Vec3::UnitX());
    if (p.at("gusts") > 0.0) {
        Wind gusts;
        gusts.name = "gusts";
        gusts.kind = WindKind::Gusts;
        gusts.gustiness = p.at("gusts");
        addItem(scene, gusts);
    }
    const Materials materials = addMaterials(scene, p);

    Network network(scene, "flag");
    const int rows = int(p.at("rows"));
    const double lower = std::max(p.at("pole") - p.at("height"), 0.1 * p.at("height"));
    const auto flag = addFlag(network, p, materials, lower);
    const bool isOfSprings = isIdeal(p, "cloth");
    network.addFabricMass(clothDensity(p, flagChoices, "density"));
    CraftMaterials craft;
    if (!isOfSprings)
        craft.hems = {addHem(scene, network, flag, hemDensity(p, flagChoices))};
    const std::vector<Id> pole = addPole(network, p, materials.pole);
    for (int row = 0; row <= rows; ++row)
        if (p.at("tied") > 0.0 || row == 0 || row == rows)
            network.rod(pole[pole.size() - 1 - std::size_t(rows - row)], flag[std::size_t(row)][0],
                        materials.ties, Resists::Tension);

    craft.cloth = {materials.cloth};
    craft.seams = {materials.structural, materials.shear};
    makeOf(p, craft, scene, network, flagChoices);

    const Id top = pole.back();
    const Id fly = flag[std::size_t(rows / 2)].back();
    const Id tie = network.part().links.back().id;
    const Id part = network.finish("pole_flag", p);
    addGroup(scene, "pole nodes", pole);
    addProbe(scene, "pole top", Quantity::PositionX, top);
    addProbe(scene, "fly", Quantity::PositionX, fly);
    addProbe(scene, "upper tie", Quantity::Tension, tie);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);

    // A pole that bends has all springs solved together with it, however stiff they are.
    if (isOfSprings && p.at("rigidity") == 0.0)
        takeShortSubsteps(scene);
    return scene;
}

} // namespace

const Builder poleFlagBuilder{
    "pole_flag", "Flag on a pole", "A flag tied to a pole that stands on the ground and may bend.",
    parameters,  buildPoleFlag,    Family::Cloth};

} // namespace ripstop
