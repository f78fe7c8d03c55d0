// neighbour() measures the material and each candidate along the step (measure()), keeps those that
// lie beyond the material on the wanted side, and takes the nearest. changesBy() goes through the
// same numbers and shows them in units that are read easily.
#include "materials/neighbours.h"

#include "materials/marks.h"
#include "scene/said_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ripstop {
namespace {

enum class Measure { Weight, Stiffness, Strength };

Measure measureOf(MaterialStep step)
{
    switch (step) {
    case MaterialStep::Lighter:
    case MaterialStep::Heavier:
        return Measure::Weight;
    case MaterialStep::Softer:
    case MaterialStep::Stiffer:
        return Measure::Stiffness;
    case MaterialStep::Weaker:
    case MaterialStep::Stronger:
        break;
    }
    return Measure::Strength;
}

bool isUpwards(MaterialStep step)
{
    return step == MaterialStep::Heavier || step == MaterialStep::Stiffer
           || step == MaterialStep::Stronger;
}

const Property& weightProperty(PresetKind kind)
{
    return isSheet(kind) ? propertyOf<&Material::arealDensity>()
                         : propertyOf<&Material::linearDensity>();
}

const Property& stiffnessProperty(PresetKind kind)
{
    switch (kind) {
    case PresetKind::Fabric:
    case PresetKind::Film:
        return propertyOf<&Material::membraneStiffness>();
    case PresetKind::Line:
        return propertyOf<&Material::axialStiffness>();
    case PresetKind::Spar:
        return propertyOf<&Material::flexuralRigidity>();
    }
    return propertyOf<&Material::axialStiffness>();
}

const Property& strengthProperty(PresetKind kind)
{
    switch (kind) {
    case PresetKind::Fabric:
    case PresetKind::Film:
        return propertyOf<&Material::warpStrength>();
    case PresetKind::Line:
        return propertyOf<&Material::lineStrength>();
    case PresetKind::Spar:
        return propertyOf<&Material::breakingMoment>();
    }
    return propertyOf<&Material::lineStrength>();
}

// A number that is there and is not 0, which of these numbers would mean that it is not known.
std::optional<double> positive(const Value& value)
{
    const double* number = std::get_if<double>(&value);
    return number && *number > 0.0 ? std::optional(*number) : std::nullopt;
}

std::optional<double> numberOf(const Material& material, const Property& property)
{
    return positive(property.get(&material));
}

std::optional<double> numberOf(const Preset& preset, const Property& property)
{
    const PresetNumber* number = findNumber(preset, property);
    return number ? positive(number->value) : std::nullopt;
}

// What it bears is less than its strength by what seams and knots leave of it.
template <typename Kind>
std::optional<double> measured(const Kind& kind, const Property& property, Measure measure)
{
    const auto number = numberOf(kind, property);
    if (!number || measure != Measure::Strength)
        return number;
    return *number * numberOf(kind, propertyOf<&Material::jointEfficiency>()).value_or(1.0);
}

Failure noneBeyond(MaterialStep step, const std::string& name)
{
    switch (step) {
    case MaterialStep::Lighter:
        return Failure("The library has nothing lighter than %1 that is known as well.", name);
    case MaterialStep::Heavier:
        return Failure("The library has nothing heavier than %1 that is known as well.", name);
    case MaterialStep::Softer:
        return Failure("The library has nothing softer than %1 that is known as well.", name);
    case MaterialStep::Stiffer:
        return Failure("The library has nothing stiffer than %1 that is known as well.", name);
    case MaterialStep::Weaker:
        return Failure("The library has nothing weaker than %1 that is known as well.", name);
    case MaterialStep::Stronger:
        break;
    }
    return Failure("The library has nothing stronger than %1 that is known as well.", name);
}

// A bare material may be of anything, so that the number is not named.
Failure notMeasured(MaterialStep step, const std::string& name)
{
    switch (measureOf(step)) {
    case Measure::Weight:
        return Failure("%1 has no density from which a step could be made: choose a material of "
                       "the library for it first.",
                       name);
    case Measure::Stiffness:
        return Failure("%1 has no stiffness from which a step could be made: choose a material "
                       "of the library for it first.",
                       name);
    case Measure::Strength:
        break;
    }
    return Failure("%1 has no strength from which a step could be made: choose a material of the "
                   "library for it first.",
                   name);
}

Message changeOf(const Property& property, double before, double after)
{
    const ReadableUnit unit = readableUnit(std::max(before, after), property.unit);
    return Message("%1 %2 → %3 %4", Message::word(property.label),
                   Message::number(plainNumber(before / unit.factor, 4)),
                   Message::number(plainNumber(after / unit.factor, 4)), unit.name);
}

Message labelOf(MaterialStep step, const Preset& preset)
{
    const Message name = Message::word(preset.label);
    switch (step) {
    case MaterialStep::Lighter:
        return Message("Lighter: %1", name);
    case MaterialStep::Heavier:
        return Message("Heavier: %1", name);
    case MaterialStep::Softer:
        return Message("Softer: %1", name);
    case MaterialStep::Stiffer:
        return Message("Stiffer: %1", name);
    case MaterialStep::Weaker:
        return Message("Weaker: %1", name);
    case MaterialStep::Stronger:
        break;
    }
    return Message("Stronger: %1", name);
}

} // namespace

std::string_view materialStepName(MaterialStep step)
{
    constexpr std::array<std::string_view, materialStepCount> names{
        "lighter", "heavier", "softer", "stiffer", "weaker", "stronger"};
    return names[std::size_t(step)];
}

Result<const Preset*> neighbour(const Material& material, MaterialStep step,
                                std::span<const Preset> own)
{
    const PresetKind kind = presetKindOf(material, own);
    const std::array<const Property*, 3> known{&weightProperty(kind), &stiffnessProperty(kind),
                                               &strengthProperty(kind)};
    const Measure measure = measureOf(step);
    const Property& property = *known[std::size_t(measure)];
    const Property& other = *known[measure == Measure::Weight ? 1 : 0];
    const auto now = measured(material, property, measure);
    if (!now)
        return notMeasured(step, material.name);
    const double sign = isUpwards(step) ? 1.0 : -1.0;
    const auto otherWay = [&](const Preset& preset) { // how far the other number goes
        const auto before = numberOf(material, other), after = numberOf(preset, other);
        return before && after ? std::abs(std::log(*after / *before)) : 0.0;
    };
    const Preset* nearest = nullptr;
    std::pair<double, double> best{std::numeric_limits<double>::infinity(), 0.0};
    for (const std::span<const Preset> presets : {allPresets(), own})
        for (const Preset& preset : presets) {
            const auto number = measured(preset, property, measure);
            const bool knowsLess = std::ranges::any_of(known, [&](const Property* one) {
                return numberOf(material, *one) && !numberOf(preset, *one);
            });
            if (!isOfOneFamily(preset.kind, kind) || knowsLess || !number
                || sign * (*number - *now) <= 0.0)
                continue;
            const std::pair way{sign * (*number - *now), otherWay(preset)};
            if (way < best) {
                best = way;
                nearest = &preset;
            }
        }
    if (!nearest)
        return noneBeyond(step, material.name);
    return nearest;
}

std::vector<Message> changesBy(const Preset& preset, const Material& before)
{
    std::vector<Message> changes;
    for (const Property* property :
         {&propertyOf<&Material::arealDensity>(), &propertyOf<&Material::linearDensity>(),
          &propertyOf<&Material::membraneStiffness>(), &propertyOf<&Material::axialStiffness>(),
          &propertyOf<&Material::flexuralRigidity>(), &propertyOf<&Material::warpStrength>(),
          &propertyOf<&Material::lineStrength>(), &propertyOf<&Material::breakingMoment>(),
          &propertyOf<&Material::jointEfficiency>()}) {
        const auto old = numberOf(before, *property), now = numberOf(preset, *property);
        if (old && now && *old != *now)
            changes.push_back(changeOf(*property, *old, *now));
    }
    return changes;
}

Result<StepEdit> stepEdit(const Scene& scene, const std::vector<Id>& materials, MaterialStep step,
                          std::span<const Preset> own)
{
    StepEdit result;
    for (const Id id : materials) {
        const Result<const Preset*> next = neighbour(*findItem<Material>(scene, id), step, own);
        if (!next)
            return next.failure();
        result.given.push_back({id, *next});
    }
    Result<PresetEdit> edit = presetEdit(scene, result.given);
    if (!edit)
        return edit.failure();
    result.edit = std::move(*edit);
    if (!result.given.empty())
        result.edit.edit.label = labelOf(step, *result.given.front().preset);
    return result;
}

} // namespace ripstop
