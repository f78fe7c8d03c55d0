// The paper's hang glider (Beaudry, Egli, Patenaude 2005, section 6) in real proportions.
//
// A triangular lattice of n segments per side, two rigidity particles tied to the leading edges and
// the keel, the pilot and the foot of the control frame tied to the whole rim. With 8 segments:
// 45 + 2 + 1 + 1 = 49 particles, 108 + 2 x 21 + 24 + 24 = 198 rods, 64 panels.
//
// Built with the nose at the origin, flying towards +x, y up, z to the right. Twisted tips and a
// raised rear keel turn the nose up at zero lift; the weight ahead of the centroid of the sail
// balances that at one angle of attack only, which is what makes the flight steady. The pilot is
// hung where the wing trims at the wanted speed, and the run starts in that trim.
//
// Of a cloth that one can buy (builders/craft_materials.h) the sail is two halves that are sewn
// along the keel, carried by panels, with tubes in the leading edges and the keel. Frame, pilot and
// wires hold these at the nose, along the keel and where the cross tube meets them: outside of it
// they bend. The trailing edge is free to rise, and luff lines from the king post, which is the
// rigidity particle above the sail, keep it from sinking.
#include "builders/craft_materials.h"
#include "builders/delta_wing.h"
#include "builders/designs.h"
#include "builders/network.h"
#include "builders/reinforcement.h"
#include "builders/statics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace ripstop {
namespace {

constexpr auto sailCloths = std::to_array<std::string_view>(
    {"ideal", "dacron_sail", "laminate_scrim", "surf_dacron", "ripstop_150"});
constexpr auto tubes =
    std::to_array<std::string_view>({"ideal", "aluminium_42", "aluminium_50", "aluminium_52",
                                     "aluminium_62", "aluminium_6061_38", "aluminium_6061_41"});
constexpr auto sailPatches =
    std::to_array<std::string_view>({"none", "dacron_sail", "laminate_scrim", "surf_dacron"});
constexpr CraftChoices choices{sailCloths, tubes, {}, {}, sailPatches};

// clang-format off
constexpr auto ownParameters = std::to_array<Parameter>({
    {"segments",    "",      8,     2, 40,    true,  "Lattice segments per side of the sail, which has their square of panels; one of real cloth has some more, in strips from the nose.", "Mesh"},
    {"span",        "m",     9.6,   2, 20,    false, "From tip to tip.", "Size and mass"},
    {"chord",       "m",     4.0,   1, 10,    false, "Length of the keel from the nose to the trailing edge."},
    {"wing_mass",   "kg",    25,    1, 100,   false, "Sail and frame together, shared equally by all particles but the pilot; where the cloth is ideal.", {}, {}, {}, isZero("cloth")},
    {"fittings",    "kg",    12,    0.1, 60,  false, "Cross tube, control frame, wires and fittings, shared by the nodes of the frame; where the cloth is real, whose weight and that of the tubes come to it.", {}, {}, {}, isNotZero("cloth")},
    {"pilot_mass",  "kg",    65,    1, 200,   false, "Pilot and harness."},
    {"pilot_depth", "m",     1.3,   0.3, 4,     false, "How far the pilot hangs below the keel."},
    {"speed",       "m/s",   11,    5, 30,    false, "Airspeed in trim; it says where along the keel the pilot hangs."},
    {"cloth",       "",      0,     0, sailCloths.size() - 1, true, "Cloth of the sail; ideal cloth never stretches and weighs what is said above, a real one is carried by panels and wrinkles.", "Materials", sailCloths, 1},
    {"spars",       "",      0,     0, tubes.size() - 1, true, "Tubes in the leading edges and, below real cloth, in the keel; ideal ones never stretch, real ones bend.", {}, tubes, 2},
    {"grain",       "deg",   0,     0, 90,    false, "Angle between the warp of real cloth and the trailing edge, mirrored at the keel; at 90 it runs along the keel.", {}, {}, {}, isNotZero("cloth")},
    {"dihedral",    "deg",   3,     -10, 20,    false, "Rise of the leading edges to the tips; rolls the wing level when it slips.", "Shape"},
    {"billow",      "",      0.02,  0, 0.3,   false, "Arch of the sail between keel and leading edge, over its local half width."},
    {"washout",     "deg",   7,     -10, 40,    false, "How much less the tips meet the wind than the root; gives pitch stability to a swept wing."},
    {"reflex",      "",      0.02,  -0.1, 0.2,   false, "Rise of the rear end of the keel over its length; gives pitch stability."},
    {"luff_lines",  "",      0,     0, 3,     true,  "Lines from the king post to the trailing edge of each half of real cloth: slack in flight, they hold it up in a dive, where it would flap down and take the nose with it.", {}, {}, 2, isNotZero("cloth")},
    {"luff_slack",  "m",     0,     0, 1,     false, "How far the trailing edge may sink below where it is cut before they hold it.", {}, {}, {}, isNotZero("luff_lines")},
    {"lift_slope",  "1/rad", 4.0,   0.1, 8,     false, "Normal force coefficient per sine of the angle of attack; 2 pi A / (2 + sqrt(A^2 + 8)) for a taut delta of aspect ratio A, 3.1 fits the first, slack Rogallo wings.", "Air"},
    {"vortex",      "",      0,     0, 1,     true,  "1 flies with the vortex law, which finds lift slope and induced drag from the shape of the wing; 0 with the plate law and the lift slope above."},
    {"drag",        "",      0.06,  0, 0.5,   false, "Drag coefficient of sail, wires, frame and pilot together, spread over the sail as skin friction."},
    {"altitude",    "m",     100,   5, 3000,  false, "Height of the nose at the start; the density of the air does not follow it, settings.airDensity sets it: 0.909 kg/m^3 at 3000 m in the standard atmosphere.", "Start"},
    {"shift",       "m",     0.4,   0.01, 1,     false, "How far the pilot can shift either way."},
});
// clang-format on
constexpr auto parameters = joined(ownParameters, patchParameters(sailPatches, 0.6));

struct Materials
{
    SailMaterials sail;
    Id wires;
    Id frame;
};

Materials addMaterials(Scene& scene, const Parameters& p)
{
    Material material;
    material.normalCoefficient = p.at("lift_slope");
    material.skinFriction = p.at("drag");
    if (p.at("vortex") != 0.0) {
        material.airLaw = AirLaw::Vortex;
        material.normalCoefficient = 2.0; // of a plate, when it stalls
        material.broadsideCoefficient = 1.17;
    }
    const auto add = [&](const char* name, const char* color, bool shown) {
        material.name = name;
        material.color = color;
        material.shown = shown;
        return addItem(scene, material);
    };
    Materials materials{};
    materials.sail.sail = add("sail", "#e76f51", true);
    materials.sail.border = add("sail edge", "#264653", true);
    materials.sail.seams = add("seams", "#c8583c", true);
    materials.sail.edges = add("tube", "#20262e", true);
    materials.sail.hem = isIdeal(p, "cloth") ? materials.sail.seams : add("hem", "#c8583c", true);
    materials.wires = add("wire", "#8d99ae", true);
    materials.frame = add("frame", "#8d99ae", false);
    return materials;
}

CraftMaterials craftMaterials(const Materials& materials)
{
    const SailMaterials& sail = materials.sail;
    CraftMaterials craft;
    craft.cloth = {sail.sail, sail.border};
    craft.seams = {sail.seams};
    if (sail.hem != sail.seams)
        craft.hems = {sail.hem};
    craft.spars = {sail.edges};
    craft.frame = {materials.wires, materials.frame};
    craft.wires = {materials.wires};
    return craft;
}

struct Wing
{
    SailFrame frame;
    SailFrame held;          // what the stiffeners are tied to
    std::vector<Id> rim;     // what pilot and control frame are tied to
    std::array<Id, 4> wired; // of these: nose, tail, and tips or ends of the cross tube
    std::vector<Id> stiffeners;
    Id pilot;
    Id foot; // of the control frame
};

Wing addIdealSail(Network& network, const DeltaShape& shape, int segments,
                  const Materials& materials)
{
    const Lattice lattice = addSail(network, shape, segments, materials.sail);
    const int n = lattice.segments();
    Wing wing{};
    wing.frame = wing.held = SailFrame::of(lattice);
    wing.rim = lattice.perimeter();
    wing.wired = {lattice.at(0, 0), lattice.at(n, 0), lattice.at(n, n), lattice.at(n, n / 2)};
    return wing;
}

// Some more panels than the ideal sail has, in rows that are three, or a multiple of it, so that
// the cross tube meets the leading edges at two thirds of them in each mesh. The cloth is cut as
// the wing is shaped.
Wing addRealSail(Network& network, const DeltaShape& shape, const Parameters& p,
                 const Materials& materials)
{
    const int thirds = std::max(1, int(std::round(p.at("segments") / (3.0 * std::numbers::sqrt2))));
    const int rows = 3 * thirds;
    Wing wing{};
    wing.frame = addHalves(network, shape, {evenRows(rows), 2 * thirds}, materials.sail);
    const std::vector<Id>& axis = wing.frame.axis;
    for (std::size_t row = 1; row < axis.size(); ++row)
        network.rod(axis[row - 1], axis[row], materials.sail.edges);
    const double grain = p.at("grain") * degrees;
    network.carryByPanels([&](const Vec3& middle) -> Vec3 {
        const double side = middle.z() < 0.0 ? -1.0 : 1.0;
        return {-std::sin(grain), 0.0, side * std::cos(grain)};
    });
    network.addFabricMass(clothDensity(p, choices));
    // nose and left side come first
    const std::vector<Id>& edges = wing.frame.leadingEdges;
    const auto across = std::size_t(2 * rows / 3);
    wing.held = {{edges[0], edges[across], edges[std::size_t(rows) + across]}, axis};
    wing.rim = wing.held.leadingEdges;
    wing.rim.insert(wing.rim.end(), axis.begin() + 1, axis.end());
    wing.wired = {edges[0], wing.held.leadingEdges[1], wing.held.leadingEdges[2], axis.back()};
    return wing;
}

// Evenly along each half, the outermost at three quarters of it: what a tip loses in a dive turns
// the nose most. What lies below the trailing edge by the slack is as far from the king post as a
// line is long.
void addLuffLines(Network& network, const Parameters& p, const Wing& wing,
                  const Materials& materials)
{
    const std::vector<Id>& edge = wing.frame.trailingEdge;
    const std::size_t nodes = edge.size() / 2; // of a half
    const std::size_t lines = std::min(std::size_t(p.at("luff_lines")), nodes);
    if (lines == 0)
        return;
    const Id post = wing.stiffeners.front();
    const Vec3 top = network.position(post);
    const Id foot = *std::ranges::min_element(wing.frame.axis, {}, [&](Id node) {
        return std::abs(network.position(node).x() - top.x());
    });
    network.linkBetween(post, foot)->material = materials.wires; // which is seen
    for (std::size_t line = 1; line <= lines; ++line) {
        const double out = 0.75 * double(line) / double(lines) * double(nodes + 1);
        const std::size_t at = std::clamp<std::size_t>(std::size_t(std::lround(out)), 1, nodes);
        for (const std::size_t half : {0u, 1u}) {
            const Id node = edge[half * nodes + at - 1];
            const Vec3 lowest = network.position(node) - p.at("luff_slack") * Vec3::UnitY();
            network.rod(post, node, materials.wires, Resists::Tension);
            network.setRestLength((lowest - top).norm());
        }
    }
}

// Shared equally for an ideal wing; else tubes weigh where they are, fittings hang on what the
// control frame is tied to, and the cloth has its mass already.
void addWingMass(Network& network, const Parameters& p, const Wing& wing,
                 const Materials& materials)
{
    std::vector<Id> carrying;
    if (isIdeal(p, "cloth")) {
        for (const Particle& particle : network.part().particles)
            carrying.push_back(particle.id);
    } else {
        network.addLinkMass(materials.sail.edges, sparDensity(p, choices));
        carrying = wing.rim;
        carrying.insert(carrying.end(), wing.stiffeners.begin(), wing.stiffeners.end());
        carrying.push_back(wing.foot);
    }
    const double mass = p.at(isIdeal(p, "cloth") ? "wing_mass" : "fittings");
    for (const Id node : carrying)
        network.row(node).mass += mass / double(carrying.size());
}

Wing addWing(Network& network, const Parameters& p, const Materials& materials)
{
    const DeltaShape shape{p.at("span"),
                           p.at("chord"),
                           p.at("dihedral") * degrees,
                           p.at("billow"),
                           p.at("washout") * degrees,
                           p.at("reflex")};
    Wing wing = isIdeal(p, "cloth") ? addIdealSail(network, shape, int(p.at("segments")), materials)
                                    : addRealSail(network, shape, p, materials);
    wing.stiffeners = addStiffeners(network, shape, wing.held, materials.frame);
    addLuffLines(network, p, wing, materials);
    const double depth = p.at("pilot_depth");
    wing.foot = network.particle({-0.6 * shape.chord, -1.25 * depth, 0.0});
    addWingMass(network, p, wing, materials);
    wing.pilot = network.particle({-0.6 * shape.chord, -depth, 0.0}, p.at("pilot_mass"));
    return wing;
}

// The least angle of attack at which the air carries the whole weight at this speed, rad.
double trimAngle(const Scene& scene, const Part& part, double speed, bool stalls)
{
    const double weight = lumpedMassOf(part).mass * scene.settings.gravity.norm();
    const auto surplus = [&](double angle) {
        const Vec3 force = airLoad(scene, part, headwind(speed, angle)).force;
        return std::copysign(force.norm(), force.y()) - weight;
    };
    const double most = 60.0 * degrees;
    double high = stalls ? 1.0 * degrees : most; // beyond the stall it may carry the weight again
    while (high < most && surplus(high) < 0.0)
        high += 1.0 * degrees;
    return root(surplus, 0.0, high);
}

// Pilot and control frame hang where the line of the air's force passes through the centre of
// mass: x Fy - y Fx = M.
void hangPilot(Network& network, const Wing& wing, const Load& air)
{
    const LumpedMass weight = lumpedMassOf(network.part());
    const double wanted = (air.moment.z() + weight.center.y() * air.force.x()) / air.force.y();
    const double hung = network.row(wing.pilot).mass + network.row(wing.foot).mass;
    const Vec3 shift((wanted - weight.center.x()) * weight.mass / hung, 0.0, 0.0);
    network.row(wing.pilot).position += shift;
    network.row(wing.foot).position += shift;
}

void addControlRods(Network& network, const Materials& materials, const Wing& wing)
{
    network.spokes(wing.pilot, wing.rim, materials.frame);
    for (const Id node : wing.rim) { // the few that a real glider has are drawn
        const bool drawn = std::ranges::find(wing.wired, node) != wing.wired.end();
        network.rod(wing.foot, node, drawn ? materials.wires : materials.frame);
    }
}

void addControls(Scene& scene, const Parameters& p, Id pilot, const Vec3& forward)
{
    Control control;
    control.kind = ControlKind::WeightShift;
    control.targets = {pilot};
    control.step = 0.05;
    control.limit = p.at("shift");
    control.rate = 0.5;

    control.name = "pitch";
    control.axis = forward;
    control.keyLess = "Down";
    control.keyMore = "Up";
    addItem(scene, control);

    control.name = "roll";
    control.axis = Vec3(0.0, 0.0, 1.0);
    control.keyLess = "Left";
    control.keyMore = "Right";
    addItem(scene, control);
}

void addProbes(Scene& scene, Id part)
{
    addProbe(scene, "height", Quantity::PositionY, part);
    addProbe(scene, "distance flown", Quantity::PositionX, part);
    addProbe(scene, "speed", Quantity::Speed, part);
    addProbe(scene, "sink rate", Quantity::SinkRate, part);
    addProbe(scene, "glide ratio", Quantity::GlideRatio, part);
    addProbe(scene, "mean glide ratio", Quantity::MeanGlideRatio, part);
    addProbe(scene, "max strain", Quantity::MaxStrain, part);
}

struct OuterChord
{
    Id nose;
    Id tail;
};

// At two thirds of the right half span.
OuterChord outerChordOf(const Network& network, const SailFrame& frame)
{
    const auto outward = [&](Id node) { return network.position(node).z(); };
    const auto nearest = [&](const std::vector<Id>& nodes, double place) {
        return *std::ranges::min_element(nodes, {},
                                         [&](Id node) { return std::abs(outward(node) - place); });
    };
    const double tip = outward(frame.leadingEdges.back());
    const Id tail = nearest(frame.trailingEdge, 2.0 / 3.0 * tip);
    return {nearest(frame.leadingEdges, outward(tail)), tail};
}

// How the sail is twisted and arched, for who looks for it.
void addProbesOfSail(Scene& scene, const SailFrame& frame, const OuterChord& outer)
{
    const auto add = [&](const char* name, Quantity quantity, Id target, Id from) {
        Probe probe;
        probe.name = name;
        probe.quantity = quantity;
        probe.target = target;
        probe.from = from;
        probe.plotted = false;
        if (quantity == Quantity::Formula)
            probe.formula = "keel_pitch - outer_pitch";
        addItem(scene, std::move(probe));
    };
    add("keel pitch", Quantity::Pitch, frame.axis.front(), frame.axis.back());
    add("outer pitch", Quantity::Pitch, outer.nose, outer.tail);
    add("twist", Quantity::Formula, noId, noId);
    add("camber", Quantity::Camber, outer.nose, outer.tail);
}

Result<Scene> buildHangGlider(const Parameters& p)
{
    Scene scene;
    scene.settings.title = "Hang glider";
    scene.settings.notes =
        "Up dives, Down slows, Left and Right roll: the keys shift the pilot's weight inside the "
        "control rods. The pilot hangs where the wing trims at the wanted speed, and the flight "
        "starts in that trim.";
    addGround(scene);
    const Materials materials = addMaterials(scene, p);

    Network network(scene, "glider");
    const Wing wing = addWing(network, p, materials);
    const std::vector<Id>& edges = wing.frame.leadingEdges; // the nose, the left side, the right
    const Result<std::vector<Id>> patches = addPatches(
        p, {edges.front(), edges[edges.size() / 2], edges.back(), wing.frame.axis.back()}, scene,
        network, choices);
    if (!patches)
        return patches.failure();
    const double speed = p.at("speed");
    const double angle = trimAngle(scene, network.part(), speed, p.at("vortex") != 0.0);
    const Load air = airLoad(scene, network.part(), headwind(speed, angle));
    hangPilot(network, wing, air);
    addControlRods(network, materials, wing);

    // in a steady glide the force of the air points straight up
    const double tilt = 0.5 * pi - std::atan2(air.force.y(), air.force.x());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(tilt, Vec3::UnitZ()).toRotationMatrix();
    network.place(turn, {0.0, p.at("altitude"), 0.0}, turn * -headwind(speed, angle));
    CraftMaterials craft = craftMaterials(materials);
    craft.patches = *patches;
    makeOf(p, craft, scene, network, choices);

    addGroup(scene, "leading edge", wing.frame.leadingEdges);
    addGroup(scene, "keel", wing.frame.axis);
    addGroup(scene, "rigidity", wing.stiffeners);
    addGroup(scene, "pilot", {wing.pilot});
    addControls(scene, p, wing.pilot, turn.col(0));
    std::optional<OuterChord> outer;
    if (!wing.frame.trailingEdge.empty())
        outer = outerChordOf(network, wing.frame);
    addProbes(scene, network.finish("hang_glider", p));
    if (outer)
        addProbesOfSail(scene, wing.frame, *outer);
    return scene;
}

} // namespace

const Builder hangGliderBuilder{
    "hang_glider", "Hang glider",   "A flexible wing with a pilot who steers by shifting weight.",
    parameters,    buildHangGlider, Family::Wings};

} // namespace ripstop
