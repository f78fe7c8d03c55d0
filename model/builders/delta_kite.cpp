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
#include "builders/delta_wing.h"
#include "builders/designs.h"
#include "builders/statics.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// clang-format off
constexpr Parameter parameters[]{
    {"segments",     "",      14,     4, 60,    true,  "Lattice segments per side of the wing; the wing has their square of panels."},
    {"keel",         "",      5,      1, 30,    true,  "Lattice segments per side of the keel, at most half of those of the wing."},
    {"line",         "",      14,     2, 200,   true,  "Segments of the line."},
    {"span",         "m",     2.4,    0.3, 12,  false, "From tip to tip; about twice the chord gives the usual nose angle of 90 degrees."},
    {"chord",        "m",     1.15,   0.2, 6,   false, "Length from the nose to the trailing edge."},
    {"keel_depth",   "m",     0.4,    0.02, 3,  false, "How far the tow point hangs below the wing; a third of the half span is usual."},
    {"tow",          "",      0.6,    0.2, 0.9, false, "Where the tow point lies below the wing, from 0 at the nose to 1; a little ahead of the centroid of the sail, which is where this law has the centre of pressure; real deltas have both further forward."},
    {"dihedral",     "deg",   8,      -10, 30,  false, "Rise of the leading edges to the tips; keeps the kite upright."},
    {"billow",       "",      0.05,   0, 0.3,   false, "Arch of the sail between keel and leading edge, over its local half width."},
    {"washout",      "deg",   10,     -10, 40,  false, "How much less the tips meet the wind than the root; the pull of the line balances the nose-up turn that it gives."},
    {"reflex",       "",      0.03,   -0.1, 0.2, false, "Rise of the trailing edge at the keel over the chord; turns the nose up like washout."},
    {"fabric",       "kg/m^2", 0.045, 0.005, 1, false, "Mass of the fabric per area; 0.045 is ripstop nylon for kites."},
    {"frame_mass",   "kg",    0.12,   0.001, 10, false, "Spars in leading edges and keel, and the ring at the tow point."},
    {"line_length",  "m",     25,     1, 1000,  false, "From the tow point to the hand."},
    {"line_density", "kg/m",  0.0005, 1e-5, 0.1, false, "Mass of the line per length."},
    {"line_diameter", "m",    0.0008, 0, 0.02,  false, "Thickness of the line, which the wind drags."},
    {"wind",         "m/s",   6,      0, 30,    false, "Speed of the wind."},
    {"gusts",        "m/s",   0,      0, 50,    false, "Wind at 20 ft whose gusts blow as well; 7.7 is light turbulence, 15.4 moderate."},
    {"launch",       "deg",   35,     5, 85,    false, "Angle of the line above the horizon at the start."},
    {"lift_slope",   "1/rad", 3.7,    0.1, 8,   false, "Normal force coefficient per sine of the angle of attack; 2 pi A / (2 + sqrt(A^2 + 8)) for a delta of aspect ratio A, less for a loose sail."},
    {"vortex",       "",      0,      0, 1,     true,  "1 flies the wing with the vortex law, which finds lift slope and induced drag from its shape; 0 with the plate law and the lift slope above; the keel has that law in any case."},
    {"drag",         "",      0.04,   0, 0.5,   false, "Drag coefficient of sail and spars edge on, as skin friction of the sail."},
    {"hand_height",  "m",     1.2,    0, 100,   false, "Height of the hand over the ground."},
};
// clang-format on

struct Materials
{
    SailMaterials sail;
    Id keel; // panels
    Id spar;
    Id line;
    Id core; // second neighbours in the line, which must not meet the wind once more
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
    materials.line = add("line", "#5c677d", true);
    material.diameter = 0.0;
    materials.core = add("line core", "#5c677d", false);
    materials.frame = add("frame", "#8d99ae", false);
    return materials;
}

struct Kite
{
    Lattice wing;
    Lattice keel;
    std::vector<Id> keelLine; // the wing's nodes over the keel, without the nose
    std::vector<Id> stiffeners;
    Id tow;
};

// The tip of the keel is the tow point; its opposite side is the rear of the wing's keel line.
Lattice addKeel(Network& network, const Parameters& p, const Lattice& wing,
                const Materials& materials)
{
    const int n = wing.segments() - wing.segments() % 2; // only even rows have a node on the axis
    const int k = std::min(int(p.at("keel")), n / 2);
    const auto onWing = [&](int column) {
        const int row = n - 2 * (k - column);
        return wing.at(row, row / 2);
    };
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
        network.rod(edge.from, edge.to, onKeelLine ? materials.spar : materials.sail.seams);
    }
    for (const Lattice::Cell& cell : keel.cells())
        network.panel(cell.a, cell.b, cell.c, materials.keel);
    return keel;
}

Kite addKite(Network& network, const Parameters& p, const Materials& materials)
{
    const DeltaShape shape{p.at("span"),
                           p.at("chord"),
                           p.at("dihedral") * degrees,
                           p.at("billow"),
                           p.at("washout") * degrees,
                           p.at("reflex")};
    const Lattice wing = addSail(network, shape, int(p.at("segments")), materials.sail);
    const Lattice keel = addKeel(network, p, wing, materials);
    network.addFabricMass(p.at("fabric"));
    Kite kite{wing, keel, wing.median(), addStiffeners(network, shape, wing, materials.frame),
              keel.at(0, 0)};

    std::vector<Id> spars = wing.sides(); // and the ring that the line is tied to
    spars.push_back(kite.tow);
    for (const std::vector<Id>& more : {kite.keelLine, kite.stiffeners})
        spars.insert(spars.end(), more.begin(), more.end());
    for (const Id node : spars)
        network.row(node).mass += p.at("frame_mass") / double(spars.size());
    return kite;
}

// The angle of attack at which air and weight do not turn the kite about the tow point, rad.
double trimAngle(const Scene& scene, const Network& network, const Kite& kite, double speed)
{
    const Vec3 tow = network.position(kite.tow);
    const Weight weight = weightOf(network.part());
    const auto moment = [&](double angle) {
        const Load air = airLoad(scene, network.part(), headwind(speed, angle));
        const Vec3 down = -weight.mass * scene.settings.gravity.norm()
                          * Vec3(std::sin(angle), std::cos(angle), 0.0);
        return (air.moment - tow.cross(air.force) + (weight.center - tow).cross(down)).z();
    };
    return root(moment, 1.0 * degrees, 60.0 * degrees);
}

// From the tow point to the hand; answers the last node of the line and the hand itself, which
// are pinned at the same place and are moved together.
std::vector<Id> addLine(Network& network, const Parameters& p, const Materials& materials, Id tow,
                        const Vec3& handPlace)
{
    const int count = int(p.at("line"));
    const Id hand = network.particle(handPlace);
    const Id end = network.particle(handPlace);
    const double mass = p.at("line_length") * p.at("line_density");
    const std::vector<Id> nodes =
        network.line(tow, end, count, mass, materials.line, Resists::Tension);
    for (int i = 1; i + 2 <= count; ++i)
        network.rod(nodes[i], nodes[i + 2], materials.core, Resists::Tension);
    for (const Id pinned : {end, hand}) {
        network.row(pinned).mass = mass / count;
        network.row(pinned).pinned = true;
    }
    return {end, hand};
}

void addControls(Scene& scene, const std::vector<Id>& hand)
{
    Control control;
    control.targets = hand;
    control.step = 0.25;
    control.limit = 10.0;
    control.rate = 2.0;

    control.name = "hand";
    control.axis = -Vec3::UnitX();
    control.keyLess = "Up";
    control.keyMore = "Down";
    addItem(scene, control);

    control.name = "hand sideways";
    control.axis = -Vec3::UnitZ();
    control.keyLess = "Left";
    control.keyMore = "Right";
    addItem(scene, control);
}

void addProbes(Scene& scene, Id kite, Id tow, Id firstLineRod, Id hand)
{
    addProbe(scene, "height", Quantity::PositionY, tow);
    addProbe(scene, "line angle", Quantity::Elevation, tow, hand);
    addProbe(scene, "distance", Quantity::Distance, tow, hand);
    addProbe(scene, "line tension", Quantity::Tension, firstLineRod);
    addProbe(scene, "speed", Quantity::Speed, tow);
    addProbe(scene, "max strain", Quantity::MaxStrain, kite);
}

Scene buildDeltaKite(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Delta kite";
    scene.settings.notes =
        "Down pulls the hand back against the wind, Up gives way, Left and Right walk sideways.";
    addGround(scene);
    addWind(scene, Vec3(p.at("wind"), 0.0, 0.0));
    if (p.at("gusts") > 0.0) {
        Wind gusts;
        gusts.name = "gusts";
        gusts.kind = WindKind::Gusts;
        gusts.gustiness = p.at("gusts");
        gusts.referenceHeight = p.at("hand_height") + 0.5 * p.at("line_length");
        addItem(scene, gusts);
    }
    const Materials materials = addMaterials(scene, p);

    Network network(scene, "kite");
    const Kite kite = addKite(network, p, materials);
    const double angle = trimAngle(scene, network, kite, std::max(1.0, p.at("wind")));
    Eigen::Matrix3d turn;
    turn.col(0) = Vec3(-std::cos(angle), std::sin(angle), 0.0);
    turn.col(1) = Vec3(std::sin(angle), std::cos(angle), 0.0);
    turn.col(2) = Vec3(0.0, 0.0, -1.0);
    const Vec3 hand(0.0, p.at("hand_height"), 0.0);
    const double launch = p.at("launch") * degrees;
    const Vec3 tow = hand + p.at("line_length") * Vec3(std::cos(launch), std::sin(launch), 0.0);
    network.place(turn, tow - turn * network.position(kite.tow), Vec3::Zero());
    const std::size_t firstLineRod = network.part().links.size();
    const std::vector<Id> held = addLine(network, p, materials, kite.tow, hand);
    const Id lineRod = network.part().links[firstLineRod].id;

    addGroup(scene, "leading edge", kite.wing.sides());
    addGroup(scene, "keel", kite.keelLine);
    addGroup(scene, "rigidity", kite.stiffeners);
    addGroup(scene, "hand end", held);
    addControls(scene, held);
    addProbes(scene, network.finish("delta_kite", p), kite.tow, lineRod, held[1]);
    return scene;
}

} // namespace

const Builder deltaKiteBuilder{"delta_kite", "Delta kite",
                               "A delta wing with a keel, on a line from a hand.", parameters,
                               buildDeltaKite};

} // namespace ripstop
