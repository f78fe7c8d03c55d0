// The table of materials, and how one of them is given to a material of a scene.
// 1. Fabrics, lines and spars each have functions that derive the stored numbers from what their
//    source gives (strength and elongation, stretch at a load, diameter and modulus); the text of
//    each preset says what was derived or assumed.
// 2. The settable properties are those that any preset sets, apart from densities. A preset that
//    is silent about one of them sets its default, so that no number of the preset before it
//    stays.
// 3. presetEdit() sets them all and changes the density only where both the old and the new are
//    known, because weighing needs both (weigh.h).
#include "scene/presets.h"

#include "scene/weigh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double pi = std::numbers::pi;

template <auto member>
std::string_view keyOf()
{
    return propertyOf<member>().key;
}

// Damping over stiffness of the tether in KiteModels: 473 N s and 614 600 N. Cloth was not measured
// and is taken to lose as much.
constexpr double dampingTime = 473.0 / 614600.0; // s
const std::string damped = " Damping time of KiteModels' Dyneema tether, 473 N s over 614 600 N";

// --- fabrics ---------------------------------------------------------------------------------

// Coated ripstop: E t of 2e4 to 6e4 N/m along the threads, on the bias a fifth to a twentieth of
// it; here 4e4 and a tenth. A strip at 45 degrees has 4 / E45 = 2 / (E t) + 1 / G + ..., so that a
// tenth makes G = E t / 38.
constexpr double coatedMembrane = 4e4; // N/m
constexpr double shearShare = 1.0 / 38.0;
const std::string coated = " E t 4e4 N/m and a bias ten times softer, which gives G t, are typical "
                           "values, unsourced; taken as airtight.";
const std::string parachute =
    "Parachute cloth after nakka-rocketry.net/paralst.html (MIL specifications): weight, and "
    "strength where known. ";

Preset fabric(const char* name, const char* label, std::string source, double density,
              double membrane, std::optional<double> shear, std::optional<double> porosity)
{
    Preset preset{
        PresetKind::Fabric, name, label, std::move(source) + damped + ", for want of its own.", {}};
    preset.values = {{keyOf<&Material::arealDensity>(), density},
                     {keyOf<&Material::membraneStiffness>(), membrane},
                     {keyOf<&Material::dampingTime>(), dampingTime}};
    if (shear)
        preset.values.emplace_back(keyOf<&Material::shearStiffness>(), *shear);
    if (porosity)
        preset.values.emplace_back(keyOf<&Material::porosity>(), *porosity);
    return preset;
}

// Uncoated nylon: a secant, strip strength (N/m) over the elongation at break.
Preset parachuteCloth(const char* name, const char* label, const char* permeability, double density,
                      double strength, std::optional<double> porosity)
{
    // 29 to 40 % for nylon fibre, Knacke 1992 section 6.6.1
    constexpr double elongation = 0.345;
    const double membrane = strength / elongation;
    return fabric(name, label,
                  parachute + permeability
                      + " E t is strength over 34.5 % elongation (Knacke 6.6.1: 29 to 40 %), G t "
                        "from a bias ten times softer.",
                  density, membrane, shearShare * membrane, porosity);
}

Preset coatedCloth(const char* name, const char* label, const std::string& source, double density)
{
    return fabric(name, label, source + coated, density, coatedMembrane,
                  shearShare * coatedMembrane, 0.0);
}

// Shear stiffness and porosity were not measured.
Preset garment(const char* name, const char* label, double density, double membrane, double bending)
{
    Preset preset = fabric(
        name, label,
        "Wang, O'Brien and Ramamoorthi 2011, data of ARCSim: weight and bending stiffness; E t is "
        "twice its C11 as read by others; shear is left to the material's own stiffness, air is "
        "held back.",
        density, membrane, std::nullopt, std::nullopt);
    preset.values.emplace_back(keyOf<&Material::bendingStiffness>(), bending);
    return preset;
}

void addFabrics(std::vector<Preset>& presets)
{
    // effective porosity c = v / sqrt(2 dp / rho) at 124.5 Pa and 1.225 kg/m^3, mean of the range
    presets.push_back(parachuteCloth("mil_7020_1", "MIL-C-7020 type I, 1.1 oz ripstop nylon",
                                     "80 to 120 cfm/ft2.", 0.0373, 7355.0, 0.0356));
    presets.push_back(parachuteCloth("mil_7020_2", "MIL-C-7020 type II, 1.6 oz twill nylon",
                                     "100 to 160 cfm/ft2.", 0.0543, 8756.0, 0.0463));
    presets.push_back(parachuteCloth("mil_7020_3", "MIL-C-7020 type III, 1.6 oz ripstop nylon",
                                     "Strength is that of type II, which weighs the same; "
                                     "permeability is not given: taken as airtight.",
                                     0.0543, 8756.0, std::nullopt));
    presets.push_back(parachuteCloth("mil_44378_1", "MIL-C-44378 type I, low permeability nylon",
                                     "0 to 5 cfm/ft2.", 0.0397, 7881.0, 0.0009));
    presets.push_back(coatedCloth("ripstop_050", "Ripstop 0.5 oz",
                                  "0.5 ounces per sailmaker's yard, 42.83 g/m2 each, unfinished.",
                                  0.0214));
    presets.push_back(coatedCloth(
        "ripstop_075", "Ripstop 0.75 oz, kite cloth",
        "B. Doyle, North Cloth (kitebuilder.com/techsheets/Fabrictech.htm): nominal 32.1 g/m2, "
        "weighs 47 finished.",
        0.047));
    presets.push_back(coatedCloth("ripstop_150", "Ripstop 1.5 oz",
                                  "1.5 ounces per sailmaker's yard, 42.83 g/m2 each, unfinished.",
                                  0.0642));
    const std::string porcher = "Porcher, weight as in OpenGlider materials/_cloth/porcher.py.";
    presets.push_back(coatedCloth("skytex_27", "Porcher Skytex 27", porcher, 0.027));
    presets.push_back(coatedCloth("skytex_29", "Porcher Skytex 29", porcher, 0.029));
    presets.push_back(coatedCloth("skytex_32", "Porcher Skytex 32", porcher, 0.032));
    presets.push_back(coatedCloth("skytex_38", "Porcher Skytex 38", porcher, 0.038));
    presets.push_back(coatedCloth("teijin_d2", "Teijin D2, canopy of surf kites",
                                  "About 52 g/m2, a typical value, unsourced.", 0.052));
    presets.push_back(garment("gray_interlock", "Grey interlock knit", 0.187, 69.0, 2.32e-5));
    presets.push_back(garment("navy_sparkle_sweat", "Sweat knit", 0.224, 25.0, 5.95e-5));
    presets.push_back(garment("camel_ponte_roma", "Ponte Roma knit", 0.284, 88.1, 3.63e-5));
    presets.push_back(garment("ivory_rib_knit", "Rib knit", 0.276, 130.0, 4.62e-5));
    presets.push_back(garment("white_swim_solid", "Swimwear", 0.204, 209.0, 6.02e-5));
    presets.push_back(garment("tango_red_jet_set", "Jet set", 0.113, 343.0, 1.43e-5));
    presets.push_back(garment("pink_ribbon_brown", "Pink ribbon brown", 0.228, 490.0, 1.17e-4));
    presets.push_back(garment("denim_11oz", "Black denim, 11 oz", 0.324, 2028.0, 6.42e-5));
    presets.push_back(
        garment("white_dots_on_black", "White dots on black", 0.128, 4055.0, 5.17e-5));
    presets.push_back(garment("royal_target", "Royal Target cotton", 0.220, 4070.0, 1.25e-4));
}

// --- lines -----------------------------------------------------------------------------------

struct Cord
{
    const char* name;
    const char* label;
    double diameter; // mm
    double load;     // N, for the stretch
    double stretch;  // %
    double strength; // N
};

constexpr Cord liros[]{
    {"liros_ltc45", "Liros LTC45", 0.55, 100, 0.85, 450},
    {"liros_ltc65", "Liros LTC65", 0.65, 100, 0.80, 650},
    {"liros_ltc80", "Liros LTC80", 0.70, 300, 1.65, 800},
    {"liros_ltc120", "Liros LTC120", 1.1, 300, 1.20, 1200},
    {"liros_ltc160", "Liros LTC160", 1.2, 300, 1.05, 1600},
    {"liros_ltc200", "Liros LTC200", 1.3, 300, 1.1, 2000},
    {"liros_tsl90", "Liros TSL090", 1.2, 300, 1.38, 900},
    {"liros_tsl140", "Liros TSL140", 1.3, 300, 0.88, 1400},
    {"liros_tsl190", "Liros TSL190", 1.55, 300, 0.71, 1900},
    {"liros_tsl280", "Liros TSL280", 1.8, 300, 0.46, 2800},
    {"liros_tsl380", "Liros TSL380", 2.2, 300, 0.46, 3800},
    {"liros_tsl500", "Liros TSL500", 2.37, 300, 0.42, 5000},
};

Preset line(const Cord& cord)
{
    const double d = cord.diameter;
    const std::string load = std::to_string(int(cord.load));
    Preset preset{PresetKind::Line,
                  cord.name,
                  cord.label,
                  "OpenGlider lines/line_types/liros.py: diameter, strength and stretch at " + load
                      + " N, from which EA is the secant; mass by the fit 0.134 d + 0.6859 d^2 g/m "
                        "(d in mm), drag coefficient 1.1 of the same program."
                      + damped + ".",
                  {}};
    preset.values = {{keyOf<&Material::linearDensity>(), 1e-3 * (0.134 * d + 0.6859 * d * d)},
                     {keyOf<&Material::axialStiffness>(), cord.load / (cord.stretch / 100.0)},
                     {keyOf<&Material::dampingTime>(), dampingTime},
                     {keyOf<&Material::diameter>(), 1e-3 * d},
                     {keyOf<&Material::dragCoefficient>(), 1.1},
                     {keyOf<&Material::tearRule>(), std::string("force")},
                     {keyOf<&Material::tearLimit>(), cord.strength}};
    return preset;
}

Preset dyneema(const char* name, const char* label, double millimetres)
{
    const double d = 1e-3 * millimetres;
    const double area = 0.25 * pi * d * d;
    Preset preset{PresetKind::Line,
                  name,
                  label,
                  "Braided Dyneema: E 55 GPa and 724 kg/m3 over the full circle, drag coefficient "
                  "0.958, as in KiteModels; strength is not given, so that it does not tear: knots "
                  "cost half of it or more."
                      + damped + ".",
                  {}};
    preset.values = {{keyOf<&Material::linearDensity>(), 724.0 * area},
                     {keyOf<&Material::axialStiffness>(), 55e9 * area},
                     {keyOf<&Material::dampingTime>(), dampingTime},
                     {keyOf<&Material::diameter>(), d},
                     {keyOf<&Material::dragCoefficient>(), 0.958}};
    return preset;
}

// --- spars -----------------------------------------------------------------------------------

Preset spar(const char* name, const char* label, const std::string& source, double rigidity,
            std::optional<double> diameter, std::optional<double> axial,
            std::optional<double> density)
{
    Preset preset{PresetKind::Spar, name, label, source, {}};
    preset.values = {{keyOf<&Material::flexuralRigidity>(), rigidity},
                     {keyOf<&Material::dragCoefficient>(), 1.1}};
    if (axial)
        preset.values.emplace_back(keyOf<&Material::axialStiffness>(), *axial);
    if (diameter)
        preset.values.emplace_back(keyOf<&Material::diameter>(), *diameter);
    if (density)
        preset.values.emplace_back(keyOf<&Material::linearDensity>(), *density);
    return preset;
}

double tubeArea(double outer, double inner) { return 0.25 * pi * (outer * outer - inner * inner); }

// EI = E pi (outer^4 - inner^4) / 64.
void addTubes(std::vector<Preset>& presets, const std::string& table)
{
    // with E the bore follows from EI, and EA from the bore
    const std::string tube =
        table + "EI and mass measured; EA from E 50 GPa and the bore that gives this EI.";
    presets.push_back(spar("fibreglass_tube_6", "Fibreglass tube 6 mm", tube, 1.95, 6e-3,
                           50e9 * tubeArea(6e-3, 4.73e-3), 0.0247));
    presets.push_back(spar("fibreglass_tube_8", "Fibreglass tube 8 mm", tube, 7.73, 8e-3,
                           50e9 * tubeArea(8e-3, 5.55e-3), 0.0382));
    const std::string stiff =
        table + "EI and mass measured; stiffer than 50 GPa of this diameter, so EA is left alone.";
    presets.push_back(
        spar("fibreglass_tube_9", "Fibreglass tube 9 mm", stiff, 17.8, 9e-3, std::nullopt, 0.0512));
    presets.push_back(spar("fibreglass_tube_10", "Fibreglass tube 10 mm", stiff, 44.8, 10e-3,
                           std::nullopt, 0.054));
    presets.push_back(spar("aluminium_42", "Aluminium 7075-T6 tube 42 x 0.9 mm",
                           "Handbook values of 7075-T6: E 71.7 GPa, 2810 kg/m3.",
                           71.7e9 * pi / 64.0 * (std::pow(42e-3, 4) - std::pow(40.2e-3, 4)), 42e-3,
                           71.7e9 * tubeArea(42e-3, 40.2e-3), 2810.0 * tubeArea(42e-3, 40.2e-3)));
}

void addSpars(std::vector<Preset>& presets)
{
    const std::string table = "jesseo.com/kites/spar-calculator.php: ";
    const std::string rod =
        table + "EI measured; EA from E 122 GPa over the full circle; its mass is not given.";
    presets.push_back(spar("carbon_rod_2", "Carbon rod 2 mm", rod, 0.096, 2e-3,
                           122e9 * tubeArea(2e-3, 0), std::nullopt));
    presets.push_back(spar("carbon_rod_3", "Carbon rod 3 mm", rod, 0.487, 3e-3,
                           122e9 * tubeArea(3e-3, 0), std::nullopt));
    presets.push_back(spar("carbon_rod_4", "Carbon rod 4 mm", rod, 1.54, 4e-3,
                           122e9 * tubeArea(4e-3, 0), std::nullopt));
    const std::string only =
        table + "EI, by F L^3 / (48 d) of 908 g on 0.6604 m; no more is given.";
    const auto bare = [&](const char* name, const char* label, double rigidity,
                          std::optional<double> diameter) {
        presets.push_back(spar(name, label, only, rigidity, diameter, std::nullopt, std::nullopt));
    };
    bare("skyshark_p90", "Skyshark P90", 3.72, std::nullopt);
    bare("skyshark_p100", "Skyshark P100", 5.09, std::nullopt);
    bare("skyshark_p400", "Skyshark P400", 6.97, std::nullopt);
    bare("wood_6", "Wooden dowel 6 mm", 0.95, 6e-3);
    bare("wood_8", "Wooden dowel 8 mm", 3.0, 8e-3);
    addTubes(presets, table);
}

std::vector<Preset> made()
{
    std::vector<Preset> presets;
    addFabrics(presets);
    for (const Cord& cord : liros)
        presets.push_back(line(cord));
    presets.push_back(dyneema("dyneema_1", "Dyneema braid 1 mm", 1.0));
    presets.push_back(dyneema("dyneema_2", "Dyneema braid 2 mm", 2.0));
    addSpars(presets);
    return presets;
}

// --- applying --------------------------------------------------------------------------------

// What some preset sets, apart from densities. Another one that has nothing to say about it brings
// the default back.
std::vector<const Property*> madeSettable()
{
    std::vector<const Property*> settable;
    for (const Property& property : propertiesOf(Kind::Material)) {
        const auto sets = [&](const Preset& preset) {
            return std::ranges::any_of(
                preset.values, [&](const auto& value) { return value.first == property.key; });
        };
        if (!weighs(property) && std::ranges::any_of(allPresets(), sets))
            settable.push_back(&property);
    }
    return settable;
}

const std::vector<const Property*>& settable()
{
    static const std::vector<const Property*> properties = madeSettable();
    return properties;
}

const Value* valueOf(const Preset& preset, const Property& property)
{
    const auto found = std::find_if(preset.values.begin(), preset.values.end(),
                                    [&](const auto& value) { return value.first == property.key; });
    return found == preset.values.end() ? nullptr : &found->second;
}

std::optional<double> numberOf(const Preset& preset, const Property& property)
{
    const Value* value = valueOf(preset, property);
    return value ? std::optional(std::get<double>(*value)) : std::nullopt;
}

SetValues setting(const Property& property, const std::vector<Id>& materials, const Value& value)
{
    return {&property, materials, {value}};
}

} // namespace

std::string_view presetKindName(PresetKind kind)
{
    constexpr std::array<std::string_view, 3> names{"fabric", "line", "spar"};
    return names[std::size_t(kind)];
}

std::span<const Preset> allPresets()
{
    static const std::vector<Preset> presets = made();
    return presets;
}

Result<const Preset*> findPreset(std::string_view name)
{
    std::vector<std::string_view> names;
    for (const Preset& preset : allPresets()) {
        if (preset.name == name)
            return &preset;
        names.push_back(preset.name);
    }
    const std::string_view near = nearest(name, names);
    return near.empty()
               ? Failure("There is no preset \"%1\"; ripstop-cli presets lists them.", name)
               : Failure("There is no preset \"%1\"; did you mean \"%2\"?", name, near);
}

const Preset* presetOf(const Material& material)
{
    const auto has = [&material](const Property& property, const Value* value) {
        return property.get(&material) == (value ? *value : property.initial);
    };
    for (const Preset& preset : allPresets()) {
        const bool alike =
            std::ranges::all_of(settable(),
                                [&](const Property* property) {
                                    return has(*property, valueOf(preset, *property));
                                })
            && std::ranges::all_of(preset.values, [&](const auto& value) {
                   return has(*findProperty(Kind::Material, value.first), &value.second);
               });
        if (alike)
            return &preset;
    }
    return nullptr;
}

void give(Material& material, const Preset& preset)
{
    for (const auto& [key, value] : preset.values)
        findProperty(Kind::Material, key)->set(&material, value);
}

Result<PresetEdit> presetEdit(const Scene& scene, const Preset& preset,
                              const std::vector<Id>& materials)
{
    PresetEdit result;
    std::vector<Change>& changes = result.edit.changes;
    result.edit.label = Message("Preset %1", Message::word(preset.label));
    for (const Property* property : settable()) {
        const Value* value = valueOf(preset, *property);
        changes.push_back({setting(*property, materials, value ? *value : property->initial)});
    }

    const bool ofArea = preset.kind == PresetKind::Fabric;
    const Property& weight =
        ofArea ? propertyOf<&Material::arealDensity>() : propertyOf<&Material::linearDensity>();
    const std::optional<double> density = numberOf(preset, weight);
    for (const Id id : materials) {
        const Material& material = *findItem<Material>(scene, id);
        const auto old = ofArea ? material.arealDensity : material.linearDensity;
        if (!density || !old) {
            result.notWeighed.push_back(id);
            continue;
        }
        changes.push_back({setting(weight, {id}, *density)});
    }
    Result<Edit> edit = weighed(scene, std::move(result.edit));
    if (!edit)
        return edit.failure();
    result.edit = std::move(*edit);
    return result;
}

} // namespace ripstop
