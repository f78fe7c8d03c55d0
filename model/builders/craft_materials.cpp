// The choice of each parameter is looked up in the library; then cloth, frame and line each have a
// function that gives their materials the numbers and takes the rods away that they replace.
#include "builders/craft_materials.h"

#include "materials/presets.h"

#include <algorithm>

namespace ripstop {
namespace {

constexpr double hemWidth = 0.02; // m, of cloth that is turned in twice
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

const Preset* clothOf(const Parameters& p) { return chosen(p, "cloth", clothChoices); }
const Preset* sparsOf(const Parameters& p) { return chosen(p, "spars", sparChoices); }
const Preset* cordOf(const Parameters& p) { return chosen(p, "cord", cordChoices); }

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

void makeCloth(const Preset& cloth, const CraftMaterials& materials, Scene& scene, Network& network)
{
    const Material numbers = numbersOf(cloth);
    forEachMaterial(scene, materials.cloth, [&](Material& m) { give(m, cloth); });
    forEachMaterial(scene, materials.hems, [&](Material& m) {
        m.axialStiffness = hemWidth * *numbers.membraneStiffness;
        m.dampingTime = numbers.dampingTime;
    });
    network.dropLinks(materials.seams);
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
}

void makeLine(const Preset& cord, const CraftMaterials& materials, Scene& scene, Network& network)
{
    forEachMaterial(scene, materials.lines, [&](Material& m) { give(m, cord); });
    network.dropLinks(materials.doubled);
}

} // namespace

bool isIdeal(const Parameters& p, std::string_view parameter)
{
    return p.at(std::string(parameter)) == 0.0;
}

double clothDensity(const Parameters& p)
{
    const Preset* cloth = clothOf(p);
    return cloth ? *numbersOf(*cloth).arealDensity : p.at("fabric");
}

double cordDensity(const Parameters& p)
{
    const Preset* cord = cordOf(p);
    return cord ? *numbersOf(*cord).linearDensity : p.at("line_density");
}

double frameMass(const Parameters& p, const std::vector<Id>& spars, const Network& network)
{
    const Preset* spar = sparsOf(p);
    if (!spar)
        return p.at("frame_mass");
    double length = 0.0;
    for (const Link& link : network.part().links)
        if (std::ranges::find(spars, link.material) != spars.end())
            length += link.restLength;
    return *numbersOf(*spar).linearDensity * length;
}

void makeOf(const Parameters& p, const CraftMaterials& materials, Scene& scene, Network& network)
{
    if (const Preset* cloth = clothOf(p))
        makeCloth(*cloth, materials, scene, network);
    if (const Preset* spar = sparsOf(p))
        makeSpars(*spar, materials, scene);
    if (const Preset* cord = cordOf(p))
        makeLine(*cord, materials, scene, network);
}

} // namespace ripstop
