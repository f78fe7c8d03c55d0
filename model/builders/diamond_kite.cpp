// The diamond kite of Eddy: a spine and a bowed cross spar, a sail of four triangles, a bridle of
// three legs and a tail. Two legs are tied half way out on the cross spar, so that the kite does
// not roll about its line, and one to the end of the spine.
//
// Two triangular lattices of n rows share the row over the cross spar. With n rows in each:
// (n+1)(n+2) - (n+1) = (n+1)^2 sail particles and 2 n^2 panels. Only even rows have a node on the
// spine, so n is even.
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
    {"segments", "",    6,    2, 40,    true,  "Rows of cloth from the cross spar to the nose, and to the tail; an odd number is made even.", "Mesh"},
    {"height",   "m",   0.9,  0.2, 6,   false, "Length of the spine.", "Shape"},
    {"width",    "m",   0.9,  0.2, 6,   false, "Length of the cross spar; Eddy's is as wide as it is high."},
    {"cross",    "",    0.33, 0.1, 0.6, false, "Where the cross spar crosses the spine, from 0 at the nose to 1."},
    {"dihedral", "deg", 12,   0, 40,    false, "Rise of the cross spar from the spine to its tips; the bow keeps the kite upright."},
    {"tow",      "",    0.31, 0.1, 0.7, false, "Where the tow point lies, from 0 at the nose to 1; a little ahead of the centroid of the sail, which is at (1 + cross) / 3.", "Bridle"},
    {"bridle",   "",    0.25, 0.05, 2,  false, "How far the tow point hangs below the sail, over the height of the kite; a long one lets the kite climb, and lean over and sweep to and fro."},
});
// clang-format on
constexpr auto parameters = joined(ownParameters, flatKiteParameters, materialParameters,
                                   patchParameters(patchChoices, 0.15), flightParameters);

struct Diamond
{
    double height; // m
    double width;  // m
    double cross;  // 1
    double rise;   // 1, of the cross spar per length out

    Vec3 place(double along, double across) const // from 0 at the nose, from -1 to 1
    {
        const double share = along <= cross ? along / cross : (1.0 - along) / (1.0 - cross);
        const double out = 0.5 * width * share * across;
        return {-along * height, rise * std::abs(out), out};
    }
};

void cover(Network& network, const Lattice& lattice, const FlatMaterials& materials, bool isFirst,
           Id cloth)
{
    const int n = lattice.segments();
    for (const Lattice::Edge& edge : lattice.edges()) {
        const bool onCross = edge.sort == Lattice::Edge::Sort::Row && edge.row == n;
        if (onCross && !isFirst)
            continue; // the other half has them
        network.rod(edge.from, edge.to,
                    onCross       ? materials.spar
                    : edge.onSide ? materials.edge
                                  : materials.seams);
    }
    for (const Lattice::Cell& cell : lattice.cells())
        network.panel(cell.a, cell.b, cell.c, cloth);
}

FlatSail addDiamond(Network& network, const FlatMaterials& materials, const Parameters& p)
{
    const Diamond shape{p.at("height"), p.at("width"), p.at("cross"),
                        std::tan(p.at("dihedral") * degrees)};
    const int n = int(p.at("segments")) + int(p.at("segments")) % 2;
    const auto node = [&](double along, double across) {
        const Vec3 place = shape.place(along, across);
        const Id id = network.particle(place);
        network.texture(id, 0.5 + place.z() / shape.width, 1.0 - along);
        return id;
    };
    const auto across = [](int row, int column) {
        return row == 0 ? 0.0 : 2.0 * column / row - 1.0;
    };
    const Lattice front(
        n, [&](int row, int column) { return node(shape.cross * row / n, across(row, column)); });
    // turned by half a turn, so that both halves are wound the same way
    const Lattice rear(n, [&](int row, int column) {
        return row == n ? front.at(n, n - column)
                        : node(1.0 - (1.0 - shape.cross) * row / n, -across(row, column));
    });
    cover(network, front, materials, true, materials.trim);
    cover(network, rear, materials, false, materials.sail);

    std::vector<Id> spine{front.at(0, 0)};
    for (const Id id : front.median())
        spine.push_back(id);
    const std::vector<Id> below = rear.median(); // the last one is on the cross spar, too
    spine.insert(spine.end(), below.rbegin() + 1, below.rend());
    spine.push_back(rear.at(0, 0));
    for (std::size_t i = 1; i < spine.size(); ++i)
        network.rod(spine[i - 1], spine[i], materials.spar);

    FlatSail sail{spine, {}, {}, rear.at(0, 0), shape.height, p.at("tow")};
    const Id middle = front.at(n, n / 2);
    const int away = std::max(int(std::lround(0.25 * n)), 1); // of the way to the tips
    sail.legs = {front.at(n, n / 2 - away), front.at(n, n / 2 + away), rear.at(0, 0)};
    sail.tips = {front.at(0, 0), front.at(n, 0), front.at(n, n), rear.at(0, 0)};
    for (int column = 0; column <= n; ++column)
        if (front.at(n, column) != middle)
            sail.frame.push_back(front.at(n, column));
    for (int row = 1; row < n; ++row) // the edge line, which spar tips and spine hold taut
        for (const Lattice* half : {&front, &rear}) {
            sail.frame.push_back(half->at(row, 0));
            sail.frame.push_back(half->at(row, row));
        }
    return sail;
}

Result<Scene> buildDiamondKite(const Parameters& p)
{
    Result<Scene> scene = flownFlatKite(
        p, {"diamond_kite", "Diamond kite", [&](Network& network, const FlatMaterials& materials) {
                return addDiamond(network, materials, p);
            }});
    // One sweep goes over the rods one after the other, left before right. What it leaves of their
    // strain differs between the sides, and with 1 % left the kite hangs 6 degrees to one of them.
    if (scene)
        scene->settings.strainGoal = 0.1;
    return scene;
}

} // namespace

const Builder diamondKiteBuilder{
    "diamond_kite",
    "Diamond kite",
    "Eddy's kite: a spine and a bowed cross spar, a bridle and a tail.",
    parameters,
    buildDiamondKite,
    Family::Wings};

} // namespace ripstop
