// The choice of each parameter is looked up in the library; then cloth, frame and line each have a
// function that gives their materials the numbers and takes the rods away that they replace.
#include "builders/craft_materials.h"

#include "builders/reinforcement.h"
#include "materials/presets.h"

#include <algorithm>

namespace ripstop {
namespace {

constexpr double hemWidth = 0.02;                        // m, of cloth that is turned in twice
constexpr std::string_view frameWire = "steel_cable_24"; // what hang gliders are braced with
// Spars of the library have no measured damping. This is the loss of fabrics and lines, and has all
// rods of a craft calm themselves, as the step that looks two places back needs it.
constexpr double sparDamping = 473.0 / 614600.0; // s

const Preset* chosen(const Parameters& p, std::string_view parameter,
                     std::span<const std::string_view> choices)
{
    const auto choice = p.find(std::string(parameter));
    if (choice == p.end() || choice->second == 0.0)
        return nullptr;
    return *findPreset(choices[std::size_t(choice->second)]);
}

const Preset* clothOf(const Parameters& p, const CraftChoices& from)
{
    return chosen(p, "cloth", from.cloth);
}
const Preset* sparsOf(const Parameters& p, const CraftChoices& from)
{
    return chosen(p, "spars", from.spars);
}
const Preset* cordOf(const Parameters& p, const CraftChoices& from)
{
    return chosen(p, "cord", from.cord);
}
const Preset* tapeOf(const Parameters& p, const CraftChoices& from)
{
    return chosen(p, "tape", from.tapes);
}

Material numbersOf(const Preset& preset)
{
    Material material;
    give(material, preset);
    return material;
}

template <typename Change> // change(material)
void forEachMaterial(Scene& scene, const std::vector<Id>& materials, Change change)
{
    for (const Id id : materials)
        change(std::get<Material>(*findItem(scene, id)));
}

// Takes rods away that something real stands for, and the materials that only they have.
void drop(const std::vector<Id>& materials, Scene& scene, Network& network)
{
    network.dropLinks(materials);
    std::erase_if(scene.items, [&](const Entry& entry) {
        return std::ranges::find(materials, entry.id) != materials.end();
    });
}

// A hem runs along either yarn or across both, so that the weaker of them counts.
void turnIn(const Material& cloth, Material& hem)
{
    hem.axialStiffness = hemWidth * *cloth.membraneStiffness;
    if (cloth.warpStrength)
        hem.lineStrength =
            hemWidth
            * std::min(*cloth.warpStrength, cloth.weftStrength.value_or(*cloth.warpStrength));
    hem.jointEfficiency = cloth.jointEfficiency;
}

void makeCloth(const Preset& cloth, const Preset* tape, const Preset* patch,
               const CraftMaterials& materials, Scene& scene, Network& network)
{
    const Material numbers = numbersOf(cloth);
    forEachMaterial(scene, materials.cloth, [&](Material& m) { give(m, cloth); });
    forEachMaterial(scene, materials.patches, [&](Material& m) {
        give(m, cloth);
        addLayer(m, numbersOf(*patch));
    });
    forEachMaterial(scene, materials.hems, [&](Material& m) {
        if (tape)
            give(m, *tape);
        else
            turnIn(numbers, m);
        m.dampingTime = numbers.dampingTime;
    });
    drop(materials.seams, scene, network);
    if (network.part().carrier != FabricKind::Panels)
        network.carryByPanels();
}

void makeSpars(const Preset& spar, const CraftMaterials& materials, Scene& scene)
{
    forEachMaterial(scene, materials.spars, [&](Material& m) {
        give(m, spar);
        m.dampingTime = sparDamping;
        m.diameter = 0.0; // the drag of spars is part of that of the sail
    });
    forEachMaterial(scene, materials.frame, [&](Material& m) {
        m.axialStiffness = numbersOf(spar).axialStiffness;
        m.dampingTime = sparDamping;
    });
    const Material cable = numbersOf(**findPreset(frameWire));
    forEachMaterial(scene, materials.wires, [&](Material& m) {
        m.lineStrength = cable.lineStrength;
        m.jointEfficiency = cable.jointEfficiency;
    });
}

void makeLine(const Preset& cord, const CraftMaterials& materials, Scene& scene, Network& network)
{
    forEachMaterial(scene, materials.lines, [&](Material& m) {
        const double typed = m.diameter;
        give(m, cord);
        if (!(numbersOf(cord).diameter > 0.0))
            m.diameter = typed; // the library does not know it of all cords
    });
    drop(materials.doubled, scene, network);
}

// What is known to break does so, as the craft would. The ideal is not.
void tearByStrength(const CraftMaterials& materials, Scene& scene)
{
    for (const auto* list : {&materials.cloth, &materials.patches, &materials.hems,
                             &materials.spars, &materials.wires, &materials.lines})
        forEachMaterial(scene, *list, [](Material& m) {
            if (m.warpStrength || m.weftStrength || m.lineStrength || m.breakingMoment)
                m.tearRule = TearRule::Strength;
        });
}

} // namespace

const Preset* patchOf(const Parameters& p, const CraftChoices& from)
{
    return chosen(p, "patch", from.patches);
}

std::vector<Id> CraftMaterials::allCloth() const
{
    std::vector<Id> all = cloth;
    all.insert(all.end(), patches.begin(), patches.end());
    return all;
}

bool isIdeal(const Parameters& p, std::string_view parameter)
{
    return p.at(std::string(parameter)) == 0.0;
}

double clothDensity(const Parameters& p, const CraftChoices& choices, std::string_view ofIdeal)
{
    const Preset* cloth = clothOf(p, choices);
    return cloth ? *numbersOf(*cloth).arealDensity : p.at(std::string(ofIdeal));
}

double cordDensity(const Parameters& p, const CraftChoices& choices, std::string_view ofIdeal)
{
    const Preset* cord = cordOf(p, choices);
    return cord ? *numbersOf(*cord).linearDensity : p.at(std::string(ofIdeal));
}

double hemDensity(const Parameters& p, const CraftChoices& choices)
{
    const Preset* tape = tapeOf(p, choices);
    return tape ? *numbersOf(*tape).linearDensity : hemWidth * clothDensity(p, choices);
}

double sparDensity(const Parameters& p, const CraftChoices& choices)
{
    const Preset* spar = sparsOf(p, choices);
    return spar ? *numbersOf(*spar).linearDensity : 0.0;
}

double frameMass(const Parameters& p, const std::vector<Id>& spars, const Network& network,
                 double ideal, const CraftChoices& choices)
{
    if (!sparsOf(p, choices))
        return ideal;
    double length = 0.0;
    for (const Link& link : network.part().links)
        if (std::ranges::find(spars, link.material) != spars.end())
            length += link.restLength;
    return sparDensity(p, choices) * length;
}

void makeOf(const Parameters& p, const CraftMaterials& materials, Scene& scene, Network& network,
            const CraftChoices& choices)
{
    if (const Preset* cloth = clothOf(p, choices))
        makeCloth(*cloth, tapeOf(p, choices), patchOf(p, choices), materials, scene, network);
    if (const Preset* spar = sparsOf(p, choices))
        makeSpars(*spar, materials, scene);
    if (const Preset* cord = cordOf(p, choices))
        makeLine(*cord, materials, scene, network);
    tearByStrength(materials, scene);
}

} // namespace ripstop
