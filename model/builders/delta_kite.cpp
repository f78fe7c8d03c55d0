// The paper's delta kite (Beaudry, Egli, Patenaude 2005, section 7) in real proportions.
//
// Wing and keel are triangular lattices that share the rear of the keel line; two rigidity
// particles are tied to the leading edges and the keel; the line starts at the tip of the keel and
// ends in the hand. With 14, 5 and 14 segments: 120 + 15 + 2 + 14 + 1 = 152 particles,
// 315 + 45 + 72 + 14 + 12 = 458 rods, 196 + 25 = 221 panels. Line rods between second neighbours
// halve the stretch that the solver leaves; doubled rods side by side would change nothing.
//
// The wing is built nose to +x and then turned into the wind, which blows towards +x over a hand
// at the origin. It starts at the angle of attack at which air and weight turn it no way about the
// tow point.
#include "builders/craft_materials.h"
#include "builders/delta_wing.h"
#include "builders/designs.h"
#include "builders/kite_flight.h"
#include "builders/reinforcement.h"
#include "builders/statics.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr auto ownParameters = std::to_array<Parameter>({
    {"segments",     "",      14,     4, 60,    true,  "Lattice segments per side of the wing, which has their square of panels; a sail of real cloth has about as many, in strips from the nose.", "Mesh"},
    {"keel",         "",      5,      1, 30,    true,  "Lattice segments per side of the keel, at most half of those of the wing.", {}, {}, {}, isZero("keel_length")},
    {"span",         "m",     2.4,    0.3, 12,  false, "From tip to tip; about twice the chord gives the usual nose angle of 90 degrees.", "Shape"},
    {"chord",        "m",     1.15,   0.2, 6,   false, "Length from the nose to the trailing edge."},
    {"keel_depth",   "m",     0.4,    0.02, 3,  false, "How far the tow point hangs below the wing; a third to a half of the half span is usual.", {}, {}, 0.5},
    {"keel_length",  "",      0,      0, 0.95,  false, "Share of the chord along which the keel is sewn to a sail of real cloth, from the trailing edge on; its segments follow from those of the wing, and spars weigh where they are, so that the kite is the same at any number of segments. 0 has as many segments as said above.", {}, {}, 0.7, isNotZero("cloth")},
    {"tow",          "",      0.6,    0.2, 0.9, false, "Where the tow point lies below the wing, from 0 at the nose to 1; a little ahead of the centroid of the sail, which is where this law has the centre of pressure; real deltas have both further forward."},
    {"dihedral",     "deg",   8,      -10, 30,  false, "Rise of the leading edges to the tips; keeps the kite upright.", {}, {}, 7},
    {"billow",       "",      0.05,   0, 0.3,   false, "Arch of the sail between keel and leading edge, over its local half width."},
    {"washout",      "deg",   10,     -10, 40,  false, "How much less the tips meet the wind than the root; the pull of the line balances the nose-up turn that it gives."},
    {"reflex",       "",      0.03,   -0.1, 0.2, false, "Rise of the trailing edge at the keel over the chord; turns the nose up like washout."},
    {"fabric",       "kg/m^2", 0.045, 0.005, 1, false, "Mass of the fabric per area; 0.045 is ripstop nylon for kites.", "Mass", {}, {}, isZero("cloth")},
    {"frame_mass",   "kg",    0.12,   0.001, 10, false, "Spars in leading edges and keel, and the ring at the tow point.", {}, {}, {}, isZero("spars")},
    {"equal_masses", "",      0,      0, 1,     true,  "1 gives all particles of the kite the same mass, as the paper on kites did; 0 weighs cloth and spars where they are."},
    {"lift_slope",   "1/rad", 3.7,    0.1, 8,   false, "Normal force coefficient per sine of the angle of attack; 2 pi A / (2 + sqrt(A^2 + 8)) for a delta of aspect ratio A, less for a loose sail.", "Air"},
    {"vortex",       "",      0,      0, 1,     true,  "1 flies the wing with the vortex law, which finds lift slope and induced drag from its shape; 0 with the plate law and the lift slope above; the keel has that law in any case."},
    {"drag",         "",      0.04,   0, 0.5,   false, "Drag coefficient of sail and spars edge on, as skin friction of the sail."},
});
// clang-format on
constexpr auto parameters = joined(ownParameters, materialParameters,
                                   patchParameters(patchChoices, 0.15), flightParameters);

struct Materials
{
    SailMaterials sail;
    Id keel; // panels
    Id spar;
    LineMaterials line;
    Id frame;
};

Materials addMaterials(Scene& scene, const Parameters& p)
{
    Material material;
    material.normalCoefficient = p.at("lift_slope");
    material.skinFriction = p.at("drag");
    const auto add = [&](const char* name, const char* color, bool shown) {
        material.name = name;
        material.color = color;
        material.shown = shown;
        return addItem(scene, material);
    };
    const Material plate = material;
    if (p.at("vortex") != 0.0) {
        material.airLaw = AirLaw::Vortex;
        material.normalCoefficient = 2.0; // of a plate, when it stalls
        material.broadsideCoefficient = 1.17;
    }
    Materials materials{};
    materials.sail.sail = add("sail", "#f4a024", true);
    materials.sail.border = add("border", "#c3342b", true);
    materials.sail.seams = add("seams", "#d4851a", true);
    materials.sail.edges = add("spar", "#20262e", true);
    materials.spar = materials.sail.edges;
    material = plate;
    materials.keel = add("keel cloth", "#2a6f97", true);
    material.diameter = p.at("line_diameter");
    materials.line.line = add("line", "#5c677d", true);
    material.diameter = 0.0;
    materials.line.core = add("line core", "#5c677d", false);
    materials.frame = add("frame", "#8d99ae", false);
    materials.sail.hem = materials.sail.seams;
    if (!isIdeal(p, "cloth"))
        materials.sail.hem = add("hem", "#d4851a", true);
    return materials;
}

CraftMaterials craftMaterials(const Materials& materials)
{
    const SailMaterials& sail = materials.sail;
    CraftMaterials craft;
    craft.cloth = {sail.sail, sail.border, materials.keel};
    craft.seams = {sail.seams};
    if (sail.hem != sail.seams)
        craft.hems = {sail.hem};
    craft.spars = {materials.spar};
    craft.frame = {materials.frame};
    craft.lines = {materials.line.line};
    craft.doubled = {materials.line.core};
    return craft;
}

struct Kite
{
    SailFrame frame;
    std::vector<Id> stiffeners;
    Id tow;
    std::vector<Id> patches; // materials
};

// The tip of the keel is the tow point; its opposite side is the rear of the wing's keel line.
// Answers that point.
Id addKeel(Network& network, const Parameters& p, int segments, const std::vector<Id>& axis,
           const Materials& materials)
{
    const int k = std::min(segments, int(axis.size()) - 1);
    const auto onWing = [&](int column) { return axis[axis.size() - 1 - std::size_t(k - column)]; };
    const Vec3 tip(-p.at("tow") * p.at("chord"), -p.at("keel_depth"), 0.0);
    const Vec3 front = network.position(onWing(0));
    const Vec3 rear = network.position(onWing(k));
    const Lattice keel(k, [&](int row, int column) {
        if (row == k)
            return onWing(column);
        const double down = double(row) / k;
        const double along = row == 0 ? 0.0 : double(column) / row;
        return network.particle(tip + down * (front + along * (rear - front) - tip));
    });
    for (const Lattice::Edge& edge : keel.edges()) {
        const bool onKeelLine = edge.sort == Lattice::Edge::Sort::Row && edge.row == k;
        network.rod(edge.from, edge.to,
                    onKeelLine    ? materials.spar
                    : edge.onSide ? materials.sail.hem
                                  : materials.sail.seams);
    }
    for (const Lattice::Cell& cell : keel.cells())
        network.panel(cell.a, cell.b, cell.c, materials.keel);
    return keel.at(0, 0);
}

// Half as many as the ideal sail has, in as many strips: about as many panels.
int realRows(const Parameters& p) { return int(std::round(0.5 * p.at("segments"))); }

// Rows that the keel is sewn to, up to the tail.
int keelRows(const Parameters& p)
{
    const double length = p.at("keel_length");
    if (isIdeal(p, "cloth"))
        return int(p.at("keel"));
    if (length == 0.0)
        return std::min(int(p.at("keel")), realRows(p));
    return std::clamp(int(std::round(length * realRows(p))), 1, realRows(p) - 1);
}

// Where the length of the keel is said, a row lies at its front, and those ahead of it and behind
// are evenly spaced each.
SailCut realCut(const Parameters& p)
{
    const int rows = realRows(p);
    const double length = p.at("keel_length");
    if (length == 0.0)
        return {evenRows(rows), rows};
    const int keel = keelRows(p);
    const int ahead = rows - keel;
    SailCut cut{{}, rows};
    for (int row = 0; row <= ahead; ++row)
        cut.rows.push_back((1.0 - length) * row / ahead);
    for (int row = 1; row <= keel; ++row)
        cut.rows.push_back(1.0 - length * (keel - row) / keel);
    return cut;
}

// A real sail is sewn along the keel, and a spar goes there from the nose to the tail.
SailFrame addWing(Network& network, const Parameters& p, const DeltaShape& shape,
                  const Materials& materials)
{
    if (isIdeal(p, "cloth"))
        return SailFrame::of(addSail(network, shape, int(p.at("segments")), materials.sail));
    const SailFrame frame = addHalves(network, shape, realCut(p), materials.sail);
    const auto ahead = std::size_t(realRows(p) - keelRows(p));
    for (std::size_t row = 0; row < ahead; ++row)
        network.rod(frame.axis[row], frame.axis[row + 1], materials.spar);
    return frame;
}

// Nodes of the frame share its mass, the ring that the line is tied to among them; spars of a kite
// that is the same at any mesh weigh where they are, but for what the ring and the two stiffeners
// have of it.
void addFrameMass(Network& network, const Parameters& p, const Kite& kite,
                  const Materials& materials)
{
    const double mass = frameMass(p, {materials.spar}, network, p.at("frame_mass"));
    std::vector<Id> apart = kite.stiffeners;
    apart.push_back(kite.tow);
    if (!isIdeal(p, "cloth") && p.at("keel_length") > 0.0) {
        constexpr double share = 0.03; // 1, of each: about that of a node of the usual mesh
        for (const Id node : apart)
            network.row(node).mass += share * mass;
        const double length = network.lengthOf(materials.spar);
        network.addLinkMass(materials.spar, (1.0 - share * double(apart.size())) * mass / length);
        return;
    }
    std::vector<Id> spars = kite.frame.leadingEdges;
    spars.push_back(kite.tow);
    spars.insert(spars.end(), kite.frame.axis.begin() + 1, kite.frame.axis.end());
    spars.insert(spars.end(), kite.stiffeners.begin(), kite.stiffeners.end());
    for (const Id node : spars)
        network.row(node).mass += mass / double(spars.size());
}

// The nose, both tips, and where the line is tied.
std::vector<Id> pulledAt(const SailFrame& frame, Id tow)
{
    const std::vector<Id>& edges = frame.leadingEdges; // the nose, the left side, the right
    return {edges.front(), edges[edges.size() / 2], edges.back(), tow};
}

Result<Kite> addKite(Scene& scene, Network& network, const Parameters& p,
                     const Materials& materials)
{
    const DeltaShape shape{p.at("span"),
                           p.at("chord"),
                           p.at("dihedral") * degrees,
                           p.at("billow"),
                           p.at("washout") * degrees,
                           p.at("reflex")};
    const SailFrame frame = addWing(network, p, shape, materials);
    const Id tow = addKeel(network, p, keelRows(p), frame.axis, materials);
    network.addFabricMass(clothDensity(p));
    const Result<std::vector<Id>> patches = addPatches(p, pulledAt(frame, tow), scene, network);
    if (!patches)
        return patches.failure();
    const Kite kite{frame, addStiffeners(network, shape, frame, materials.frame), tow, *patches};
    addFrameMass(network, p, kite, materials);
    if (p.at("equal_masses") > 0.0)
        network.shareMass();
    return kite;
}

Result<Scene> buildDeltaKite(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Delta kite";
    scene.settings.notes = kiteNotes;
    addGround(scene);
    addKiteWind(scene, p);
    const Materials materials = addMaterials(scene, p);

    Network network(scene, "kite");
    const Result<Kite> made = addKite(scene, network, p, materials);
    if (!made)
        return made.failure();
    const Kite& kite = *made;
    launch(scene, network, p, kite.tow);
    const FlyingLine line = addFlyingLine(network, p, materials.line, kite.tow);
    CraftMaterials craft = craftMaterials(materials);
    craft.patches = kite.patches;
    makeOf(p, craft, scene, network);

    addGroup(scene, "leading edge", kite.frame.leadingEdges);
    addGroup(scene, "keel", {kite.frame.axis.begin() + 1, kite.frame.axis.end()});
    addGroup(scene, "rigidity", kite.stiffeners);
    addGroup(scene, "hand end", line.hand);
    addHandControls(scene, line.hand);
    addKiteProbes(scene, p, network.finish("delta_kite", p), kite.tow, line);
    return scene;
}

} // namespace

const Builder deltaKiteBuilder{
    "delta_kite", "Delta kite",   "A delta wing with a keel, on a line from a hand.",
    parameters,   buildDeltaKite, Family::Wings};

} // namespace ripstop
