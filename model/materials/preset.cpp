// Names first, then what a weave can be at all (yarn bound, positive definite), then the text that
// says where the numbers are from: each source once, in the order in which it comes up.
#include "materials/preset.h"

#include "scene/typed_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

std::optional<double> numberAt(const Preset& preset, const Property& property)
{
    const PresetNumber* number = findNumber(preset, property);
    return number ? std::optional(std::get<double>(number->value)) : std::nullopt;
}

// "Label (standing)" of a number; labels are those of the table of properties.
std::string titleOf(const PresetNumber& number)
{
    const Property* property = findProperty(Kind::Material, number.key);
    return std::string(property ? property->label : "Elongation at break") + " ("
           + std::string(standingName(number.standing)) + ")";
}

} // namespace

std::string_view presetKindName(PresetKind kind)
{
    constexpr std::array<std::string_view, presetKindCount> names{"fabric", "film", "line", "spar"};
    return names[std::size_t(kind)];
}

bool isSheet(PresetKind kind) { return kind == PresetKind::Fabric || kind == PresetKind::Film; }

std::string_view standingName(NumberStanding standing)
{
    constexpr std::array<std::string_view, numberStandingCount> names{
        "measured", "listed", "derived", "typical", "assumed"};
    return names[std::size_t(standing)];
}

const PresetNumber* findNumber(const Preset& preset, const Property& property)
{
    const auto found = std::ranges::find_if(
        preset.values, [&](const PresetNumber& number) { return number.key == property.key; });
    return found == preset.values.end() ? nullptr : &*found;
}

std::string_view unitOf(const Preset& preset, const PresetNumber& number)
{
    const Property* property = findProperty(Kind::Material, number.key);
    if (!property)
        return {};
    Material example;
    const Property& rule = propertyOf<&Material::tearRule>();
    if (const PresetNumber* tears = findNumber(preset, rule))
        rule.set(&example, tears->value);
    return unitOf(Scene(), *property, &example);
}

bool isPhysical(const Property& property)
{
    return isOneOf<&Material::dampingTime, &Material::axialStiffness, &Material::membraneStiffness,
                   &Material::shearStiffness, &Material::weftStiffness, &Material::poissonRatio,
                   &Material::bendingStiffness, &Material::flexuralRigidity,
                   &Material::arealDensity, &Material::linearDensity, &Material::tearRule,
                   &Material::tearLimit, &Material::porosity, &Material::diameter,
                   &Material::dragCoefficient, &Material::warpStrength, &Material::weftStrength,
                   &Material::tearStrength, &Material::lineStrength, &Material::breakingMoment,
                   &Material::jointEfficiency>(property);
}

std::optional<double> strongestMembrane(Yarn yarn, double arealDensity)
{
    switch (yarn) {
    case Yarn::Unknown:
        return std::nullopt;
    case Yarn::Nylon:
        return 0.5 * arealDensity * 4.0e6;
    case Yarn::Polyester:
        return 0.5 * arealDensity * 9.7e6;
    case Yarn::Polyethylene:
        return 0.5 * arealDensity * 113e6;
    }
    return std::nullopt;
}

std::optional<Message> implausible(const Preset& preset)
{
    const auto warp = numberAt(preset, propertyOf<&Material::membraneStiffness>());
    if (!warp)
        return std::nullopt;
    const double weft = numberAt(preset, propertyOf<&Material::weftStiffness>()).value_or(*warp);
    const double ratio =
        numberAt(preset, propertyOf<&Material::poissonRatio>()).value_or(Material().poissonRatio);
    if (ratio * ratio * weft >= *warp)
        return Message("Poisson's ratio %1 is too large: with E t of %2 N/m along the warp and "
                       "%3 N/m across it, it must be below %4",
                       Message::number("%.3g", ratio), Message::number("%.4g", *warp),
                       Message::number("%.4g", weft),
                       Message::number("%.3g", std::sqrt(*warp / weft)));
    const auto density = numberAt(preset, propertyOf<&Material::arealDensity>());
    const auto bound = density ? strongestMembrane(preset.yarn, *density) : std::optional<double>();
    if (bound && std::max(*warp, weft) > *bound)
        return Message("E t of %1 N/m is more than the yarn in it can hold, %2 N/m at this weight; "
                       "look at the units",
                       Message::number("%.4g", std::max(*warp, weft)),
                       Message::number("%.4g", *bound));
    return std::nullopt;
}

std::string sourcesOf(const Preset& preset)
{
    std::vector<std::pair<std::string, std::string>> groups; // source, what it tells of
    const auto add = [&](const std::string& source, const std::string& title) {
        const auto found =
            std::ranges::find_if(groups, [&](const auto& group) { return group.first == source; });
        if (found == groups.end())
            groups.emplace_back(source, title);
        else
            found->second += ", " + title;
    };
    for (const PresetNumber& number : preset.values)
        add(number.source, titleOf(number));
    if (preset.breakElongation)
        add(preset.breakElongation->source, titleOf(*preset.breakElongation));
    if (!preset.curve.points.empty())
        add(preset.curve.source,
            "Curve of stretch (" + std::string(standingName(preset.curve.standing)) + ")");
    std::string text = preset.note;
    for (const auto& [source, titles] : groups)
        text += (text.empty() ? "" : "\n") + titles + ": " + source;
    return text;
}

} // namespace ripstop
