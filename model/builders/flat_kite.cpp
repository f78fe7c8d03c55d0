// Builds a kite around the sail that its builder lays: materials, sail and mass of the fabric, the
// two rigidity particles, the bridle, the mass of the frame; then launch() turns the kite into its
// trim. Tail and line follow after that, because they lie in the frame of the scene; groups,
// controls and probes come last.
#include "builders/flat_kite.h"

#include "builders/craft_materials.h"
#include "builders/reinforcement.h"
#include "builders/statics.h"

#include <cmath>

namespace ripstop {
namespace {

struct Rigging
{
    LineMaterials line;
    Id bridle;
    Id tail;
    Id frame;
};

FlatMaterials addSailMaterials(Scene& scene, const Parameters& p)
{
    Material material;
    material.normalCoefficient = p.at("lift_slope");
    material.broadsideCoefficient = std::min(1.17, p.at("lift_slope"));
    material.skinFriction = p.at("drag");
    const auto add = [&](const char* name, const char* color) {
        material.name = name;
        material.color = color;
        return addItem(scene, material);
    };
    FlatMaterials materials{};
    materials.sail = add("sail", "#2a9d8f");
    materials.trim = add("trim", "#e9c46a");
    materials.seams = add("seams", "#21867a");
    materials.spar = add("spar", "#20262e");
    materials.edge = add("edge", "#f4f1de");
    return materials;
}

Rigging addRigging(Scene& scene, const Parameters& p)
{
    Material material;
    const auto add = [&](const char* name, const char* color, double diameter, bool shown) {
        material.name = name;
        material.color = color;
        material.diameter = diameter;
        material.shown = shown;
        return addItem(scene, material);
    };
    Rigging rigging{};
    rigging.line.line = add("line", "#5c677d", p.at("line_diameter"), true);
    rigging.line.core = add("line core", "#5c677d", 0.0, false);
    rigging.bridle = add("bridle", "#8d5a97", p.at("line_diameter"), true);
    rigging.tail = add("tail", "#c3342b", p.at("tail_width"), true);
    rigging.frame = add("frame", "#8d99ae", 0.0, false);
    return rigging;
}

std::vector<Id> addHubs(Network& network, const FlatSail& sail, Id material)
{
    std::vector<Id> hubs;
    for (const double side : {1.0, -1.0}) {
        hubs.push_back(network.particle({-0.45 * sail.height, side * 0.5 * sail.height, 0.0}));
        network.spokes(hubs.back(), sail.frame, material);
    }
    return hubs;
}

Id addBridle(Network& network, const Parameters& p, const FlatSail& sail, Id material)
{
    const Id tow = network.particle({-sail.tow * sail.height, -p.at("bridle") * sail.height, 0.0});
    for (const Id leg : sail.legs)
        network.rod(leg, tow, material, Resists::Tension);
    return tow;
}

// Lays the tail, which streams away with the wind, a little downwards.
std::vector<Id> addTail(Network& network, const Parameters& p, Id from, Id material)
{
    if (p.at("tail_length") <= 0.0)
        return {};
    const double length = p.at("tail_length");
    const Vec3 along = Vec3(0.9, -std::sqrt(1.0 - 0.81), 0.0);
    const Id end = network.particle(network.position(from) + length * along);
    std::vector<Id> nodes = network.line(from, end, int(p.at("tail_segments")),
                                         length * p.at("tail_density"), material, Resists::Tension);
    nodes.erase(nodes.begin());
    return nodes;
}

} // namespace

Result<Scene> flownFlatKite(const Parameters& p, const FlatKite& kite)
{
    Scene scene;
    scene.settings.title = kite.title;
    scene.settings.notes = kiteNotes;
    addGround(scene);
    addKiteWind(scene, p);
    const FlatMaterials materials = addSailMaterials(scene, p);
    const Rigging rigging = addRigging(scene, p);

    Network network(scene, "kite");
    const FlatSail sail = kite.sail(network, materials);
    network.addFabricMass(clothDensity(p));
    std::vector<Id> pulledAt = sail.tips;
    pulledAt.insert(pulledAt.end(), sail.legs.begin(), sail.legs.end());
    const Result<std::vector<Id>> patches = addPatches(p, pulledAt, scene, network);
    if (!patches)
        return patches.failure();
    const std::vector<Id> hubs = addHubs(network, sail, rigging.frame);
    const Id tow = addBridle(network, p, sail, rigging.bridle);
    std::vector<Id> carrying = sail.frame; // the mass of spars and ring
    carrying.insert(carrying.end(), hubs.begin(), hubs.end());
    carrying.push_back(tow);
    const double mass = frameMass(p, {materials.spar}, network, p.at("frame_mass"));
    for (const Id node : carrying)
        network.row(node).mass += mass / double(carrying.size());

    launch(scene, network, p, tow);
    const std::vector<Id> tail = addTail(network, p, sail.tail, rigging.tail);
    const FlyingLine line = addFlyingLine(network, p, rigging.line, tow);
    CraftMaterials craft;
    craft.cloth = {materials.sail, materials.trim};
    craft.patches = *patches;
    craft.seams = {materials.seams};
    craft.hems = {materials.edge, rigging.tail};
    craft.spars = {materials.spar};
    craft.frame = {rigging.frame};
    craft.lines = {rigging.line.line, rigging.bridle};
    craft.doubled = {rigging.line.core};
    makeOf(p, craft, scene, network);

    addGroup(scene, "spars", sail.frame);
    addGroup(scene, "rigidity", hubs);
    addGroup(scene, "bridle points", sail.legs);
    if (!tail.empty())
        addGroup(scene, "tail nodes", tail);
    addGroup(scene, "hand end", line.hand);
    addHandControls(scene, line.hand);
    addKiteProbes(scene, p, network.finish(kite.builder, p), tow, line);
    return scene;
}

} // namespace ripstop
