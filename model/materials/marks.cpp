// marksOf() takes the presets of the material's family that have the number, or of all families
// where the material's own has none, sorts them by value and joins those that are equal.
#include "materials/marks.h"

#include "materials/presets.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace ripstop {
namespace {

constexpr double reach = 4.0; // of a slider, from its value either way

// Two digits are what a person would type as the end of a range.
double roundedEnd(double value)
{
    char text[32];
    const char* end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 2).ptr;
    std::from_chars(text, end, value);
    return value;
}

} // namespace

std::span<const Property* const> tradeNumbers()
{
    static const std::array<const Property*, 8> numbers{
        &propertyOf<&Material::membraneStiffness>(), &propertyOf<&Material::weftStiffness>(),
        &propertyOf<&Material::shearStiffness>(),    &propertyOf<&Material::axialStiffness>(),
        &propertyOf<&Material::flexuralRigidity>(),  &propertyOf<&Material::warpStrength>(),
        &propertyOf<&Material::weftStrength>(),      &propertyOf<&Material::lineStrength>()};
    return numbers;
}

bool isTradeNumber(const Property& property)
{
    return std::ranges::find(tradeNumbers(), &property) != tradeNumbers().end();
}

bool isOfOneFamily(PresetKind a, PresetKind b) { return a == b || (isSheet(a) && isSheet(b)); }

PresetKind presetKindOf(const Material& material, std::span<const Preset> own)
{
    const Preset* preset = presetOf(material, own);
    return preset ? preset->kind : likelyKind(material);
}

std::vector<LibraryMark> marksOf(const Property& property, const Material& material,
                                 std::span<const Preset> own)
{
    std::vector<LibraryMark> marks;
    if (!isTradeNumber(property))
        return marks;
    const PresetKind kind = presetKindOf(material, own);
    std::vector<std::pair<double, const Preset*>> found;
    std::vector<std::pair<double, const Preset*>> ofFamily;
    for (const std::span<const Preset> presets : {allPresets(), own})
        for (const Preset& preset : presets) {
            const PresetNumber* number = findNumber(preset, property);
            const double* value = number ? std::get_if<double>(&number->value) : nullptr;
            if (!value || *value == 0.0)
                continue;
            found.emplace_back(*value, &preset);
            if (isOfOneFamily(preset.kind, kind))
                ofFamily.emplace_back(*value, &preset);
        }
    if (!ofFamily.empty())
        found = std::move(ofFamily);
    std::ranges::stable_sort(found, {}, &std::pair<double, const Preset*>::first);
    for (const auto& [value, preset] : found)
        if (!marks.empty() && marks.back().value == value)
            marks.back().presets.push_back(preset);
        else
            marks.push_back({value, {preset}});
    return marks;
}

SliderRange rangeAmongMarks(double value)
{
    return {roundedEnd(value / reach), roundedEnd(value * reach), true};
}

std::string_view shortLabelOf(const Preset& preset)
{
    return preset.shortLabel.empty() ? preset.label : preset.shortLabel;
}

} // namespace ripstop
