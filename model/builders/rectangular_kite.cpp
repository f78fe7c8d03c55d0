// A rectangular kite: a sheet over a bowed frame, a bridle of four legs and a tail.
//
// (c+1)(r+1) sail particles, c (r+1) + r (c+1) threads and c r diagonals, 2 c r panels.
#include "builders/craft_materials.h"
#include "builders/designs.h"
#include "builders/flat_kite.h"
#include "builders/reinforcement.h"
#include "builders/statics.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr auto ownParameters = std::to_array<Parameter>({
    {"columns", "",    8,    2, 60,    true,  "Cells across; an odd number is made even, so that the spine has its nodes.", "Mesh"},
    {"rows",    "",    8,    2, 60,    true,  "Cells from the leading to the trailing edge."},
    {"width",   "m",   0.9,  0.2, 10,  false, "From side to side.", "Shape"},
    {"height",  "m",   1.1,  0.2, 10,  false, "From the leading to the trailing edge."},
    {"bow",     "",    0.1,  0, 0.4,   false, "Depth of the bow across over the width; it keeps the kite upright."},
    {"tow",     "",    0.42, 0.1, 0.7, false, "Where the tow point lies, from 0 at the leading edge to 1; a little ahead of the middle, where the centroid of the sail is.", "Bridle"},
    {"bridle",  "",    0.45, 0.05, 2,   false, "How far the tow point hangs below the sail, over the height of the kite; a long one lets the kite climb, and lean over and sweep to and fro."},
    {"front_legs", "", 0.15, 0, 0.45,  false, "Where the two front legs of the bridle are tied, from 0 at the leading edge to 1."},
    {"rear_legs", "",  0.85, 0.55, 1,  false, "Where the two rear legs are tied."},
});
// clang-format on
constexpr auto parameters = joined(ownParameters, flatKiteParameters, materialParameters,
                                   patchParameters(patchChoices, 0.15), flightParameters);

FlatSail addRectangle(Network& network, const FlatMaterials& materials, const Parameters& p)
{
    const int columns = int(p.at("columns")) + int(p.at("columns")) % 2;
    const int rows = int(p.at("rows"));
    std::vector<Id> nodes;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double u = 2.0 * column / columns - 1.0;
            const double v = double(row) / rows;
            nodes.push_back(
                network.particle({-v * p.at("height"), p.at("bow") * p.at("width") * u * u,
                                  0.5 * u * p.at("width")}));
            network.texture(nodes.back(), 0.5 + 0.5 * u, 1.0 - v);
        }
    const auto at = [&](int row, int column) {
        return nodes[std::size_t(row * (columns + 1) + column)];
    };
    const auto isSpar = [&](int row, int column) {
        return row == 0 || row == rows || column == 0 || column == columns || column == columns / 2;
    };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column)
            network.rod(at(row, column), at(row, column + 1),
                        row == 0 || row == rows ? materials.spar : materials.seams);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column <= columns; ++column)
            network.rod(at(row, column), at(row + 1, column),
                        column == columns / 2              ? materials.spar
                        : column == 0 || column == columns ? materials.edge
                                                           : materials.seams);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Id a = at(row, column), b = at(row, column + 1);
            const Id c = at(row + 1, column), d = at(row + 1, column + 1);
            const Id cloth = row == 0 || row == rows - 1 ? materials.trim : materials.sail;
            const bool leansRight = (row + column) % 2 == 0; // no grain
            network.rod(leansRight ? a : b, leansRight ? d : c, materials.seams);
            network.panel(a, c, leansRight ? d : b, cloth);
            network.panel(leansRight ? a : c, d, b, cloth);
        }

    FlatSail sail{{}, {}, {}, at(rows, columns / 2), p.at("height"), p.at("tow")};
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            if (isSpar(row, column))
                sail.frame.push_back(at(row, column));
    sail.tips = {at(0, 0), at(0, columns), at(rows, 0), at(rows, columns)};
    const int quarter = std::max(columns / 4, 1);
    for (const char* legs : {"front_legs", "rear_legs"}) {
        const int row = int(std::lround(p.at(legs) * rows));
        sail.legs.push_back(at(row, columns / 2 - quarter));
        sail.legs.push_back(at(row, columns / 2 + quarter));
    }
    return sail;
}

Result<Scene> buildRectangularKite(const Parameters& p)
{
    return flownFlatKite(p, {"rectangular_kite", "Rectangular kite",
                             [&](Network& network, const FlatMaterials& materials) {
                                 return addRectangle(network, materials, p);
                             }});
}

} // namespace

const Builder rectangularKiteBuilder{
    "rectangular_kite",
    "Rectangular kite",
    "A sheet over a bowed frame, a bridle of four legs and a tail.",
    parameters,
    buildRectangularKite,
    Family::Wings};

} // namespace ripstop
