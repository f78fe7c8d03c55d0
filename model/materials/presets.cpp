// The library, and how one of its materials is given to a material of a scene.
// 1. The library is a text in the program, made of resources/materials.json by the build, and is
//    read once. That it can be read is tested (tests/model/test_materials_file.cpp).
// 2. The settable properties are the physical ones, apart from densities. A preset that is silent
//    about one of them sets its default, so that no number of the preset before it stays. A
//    material that tears by its strengths goes on to do so where the preset is of the same kind.
// 3. presetEdit() sets them all and changes the density only where both the old and the new are
//    known, because weighing needs both (weigh.h).
#include "materials/presets.h"

#include "materials/material_file.h"
#include "scene/weigh.h"

#include <algorithm>
#include <cassert>

namespace ripstop {
namespace {

std::vector<Preset> library()
{
    Result<std::vector<Preset>> presets = readMaterials(presetFileText(), "materials.json");
    assert(presets);
    return presets ? std::move(*presets) : std::vector<Preset>();
}

std::vector<const Property*> madeSettable()
{
    std::vector<const Property*> settable;
    for (const Property& property : propertiesOf(Kind::Material))
        if (isPhysical(property) && !weighs(property))
            settable.push_back(&property);
    return settable;
}

const std::vector<const Property*>& settable()
{
    static const std::vector<const Property*> properties = madeSettable();
    return properties;
}

bool hasStrengthOf(const Material& material, PresetKind kind)
{
    if (isSheet(kind))
        return material.warpStrength || material.weftStrength;
    return kind == PresetKind::Line ? material.lineStrength.has_value()
                                    : material.breakingMoment.has_value();
}

// Whether it tears by strengths, and by those that the preset brings others of; a sail is no line.
bool goesOnTearing(const Material& material, const Preset& preset)
{
    const auto has = [&](PresetKind kind) { return hasStrengthOf(material, kind); };
    const bool hasNone =
        !has(PresetKind::Fabric) && !has(PresetKind::Line) && !has(PresetKind::Spar);
    return isByStrength(material.tearRule) && (has(preset.kind) || hasNone);
}

// What the preset makes of a property of a material.
Value valueFor(const Material& material, const Preset& preset, const Property& property)
{
    if (isOneOf<&Material::tearRule>(property) && goesOnTearing(material, preset))
        return property.get(&material);
    const PresetNumber* number = findNumber(preset, property);
    return number ? number->value : property.initial;
}

bool isAlike(const Material& material, const Preset& preset)
{
    const auto has = [&](const Property& property) {
        return (isOneOf<&Material::tearLimit>(property) && isByStrength(material.tearRule))
               || property.get(&material) == valueFor(material, preset, property);
    };
    return std::ranges::all_of(settable(), [&](const Property* property) { return has(*property); })
           && std::ranges::all_of(preset.values, [&](const PresetNumber& number) {
                  return has(*findProperty(Kind::Material, number.key));
              });
}

SetValues setting(const Property& property, const std::vector<Id>& materials, const Value& value)
{
    return {&property, materials, {value}};
}

} // namespace

std::span<const Preset> allPresets()
{
    static const std::vector<Preset> presets = library();
    return presets;
}

Result<const Preset*> findPreset(std::string_view name, std::span<const Preset> own)
{
    std::vector<std::string_view> names;
    for (const std::span<const Preset> presets : {allPresets(), own})
        for (const Preset& preset : presets) {
            if (preset.name == name)
                return &preset;
            names.push_back(preset.name);
        }
    const std::string_view near = nearest(name, names);
    return near.empty()
               ? Failure("There is no preset \"%1\"; ripstop-cli presets lists them.", name)
               : Failure("There is no preset \"%1\"; did you mean \"%2\"?", name, near);
}

const Preset* presetOf(const Material& material, std::span<const Preset> own)
{
    for (const std::span<const Preset> presets : {own, allPresets()})
        for (const Preset& preset : presets)
            if (isAlike(material, preset))
                return &preset;
    return nullptr;
}

void give(Material& material, const Preset& preset)
{
    for (const PresetNumber& number : preset.values)
        findProperty(Kind::Material, number.key)->set(&material, number.value);
}

PresetKind likelyKind(const Material& material)
{
    if (material.flexuralRigidity > 0.0)
        return PresetKind::Spar;
    return material.membraneStiffness || material.arealDensity ? PresetKind::Fabric
                                                               : PresetKind::Line;
}

Preset presetFrom(const Material& material, PresetKind kind, std::string name, std::string source,
                  const Preset* like)
{
    Preset preset;
    preset.kind = kind;
    preset.label = name;
    preset.name = std::move(name);
    if (like) {
        preset.yarn = like->yarn;
        preset.breakElongation = like->breakElongation;
        preset.curve = like->curve;
    }
    for (const Property& property : propertiesOf(Kind::Material)) {
        Value value = property.get(&material);
        if (!isPhysical(property) || value == property.initial)
            continue;
        const PresetNumber* known = like ? findNumber(*like, property) : nullptr;
        if (known && known->value == value)
            preset.values.push_back(*known);
        else
            preset.values.push_back(
                {property.key, std::move(value), NumberStanding::Assumed, source});
    }
    return preset;
}

Result<PresetEdit> presetEdit(const Scene& scene, const std::vector<GivenPreset>& given)
{
    PresetEdit result;
    if (given.empty())
        return result;
    result.edit.label = Message("Preset %1", Message::word(given.front().preset->label));
    for (const Property* property : settable()) {
        SetValues values{property, {}, {}};
        for (const GivenPreset& one : given) {
            values.targets.push_back(one.material);
            values.values.push_back(
                valueFor(*findItem<Material>(scene, one.material), *one.preset, *property));
        }
        result.edit.changes.push_back({std::move(values)});
    }
    for (const auto& [id, preset] : given) {
        const bool ofArea = isSheet(preset->kind);
        const Property& weight =
            ofArea ? propertyOf<&Material::arealDensity>() : propertyOf<&Material::linearDensity>();
        const PresetNumber* density = findNumber(*preset, weight);
        const Material& material = *findItem<Material>(scene, id);
        const auto old = ofArea ? material.arealDensity : material.linearDensity;
        if (density && old)
            result.edit.changes.push_back({setting(weight, {id}, density->value)});
        else
            result.notWeighed.push_back(id);
    }
    Result<Edit> edit = weighed(scene, std::move(result.edit));
    if (!edit)
        return edit.failure();
    result.edit = std::move(*edit);
    return result;
}

Result<PresetEdit> presetEdit(const Scene& scene, const Preset& preset,
                              const std::vector<Id>& materials)
{
    std::vector<GivenPreset> given;
    for (const Id id : materials)
        given.push_back({id, &preset});
    return presetEdit(scene, given);
}

} // namespace ripstop
