// One number as a text, then the three ways to print them all: a paragraph for each material, JSON
// with everything, and the page docs/material-library.md.
#include "cli/preset_list.h"

#include "scene/path.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <iostream>
#include <map>

namespace ripstop {
namespace {

std::string textOf(const PresetNumber& number)
{
    const double* value = std::get_if<double>(&number.value);
    return value ? shortNumber(*value) : textFromValue(number.value);
}

std::string withUnitOf(const Preset& preset, const PresetNumber& number)
{
    const std::string_view unit = unitOf(preset, number);
    return unit.empty() ? textOf(number) : textOf(number) + ' ' + std::string(unit);
}

// The numbers of the preset, those that no scene has besides.
std::vector<PresetNumber> numbersOf(const Preset& preset)
{
    std::vector<PresetNumber> numbers = preset.values;
    if (preset.breakElongation)
        numbers.push_back(*preset.breakElongation);
    return numbers;
}

std::string curveText(const Preset& preset)
{
    std::string text;
    for (const StretchPoint& point : preset.curve.points)
        text += (text.empty() ? "" : ", ") + shortNumber(point.load)
                + (isSheet(preset.kind) ? " N/m: " : " N: ") + shortNumber(100.0 * point.strain)
                + " %";
    return text;
}

Json jsonOf(const PresetNumber& number, std::string_view unit)
{
    const double* value = std::get_if<double>(&number.value);
    return {{"value", value ? Json(*value) : Json(textFromValue(number.value))},
            {"unit", unit},
            {"standing", standingName(number.standing)},
            {"source", number.source}};
}

Json jsonOf(const Preset& preset)
{
    Json values = Json::object(), numbers = Json::object();
    for (const PresetNumber& number : numbersOf(preset)) {
        numbers[std::string(number.key)] = jsonOf(number, unitOf(preset, number));
        if (number.key != breakElongationKey)
            values[std::string(number.key)] = numbers[std::string(number.key)]["value"];
    }
    Json curve = Json::array();
    for (const StretchPoint& point : preset.curve.points)
        curve.push_back({{"load", point.load}, {"strain", point.strain}});
    return {{"name", preset.name},
            {"label", preset.label},
            {"kind", presetKindName(preset.kind)},
            {"own", preset.own},
            {"values", std::move(values)},
            {"numbers", std::move(numbers)},
            {"curve", std::move(curve)},
            {"note", preset.note},
            {"source", sourcesOf(preset)}};
}

std::string ownMark(const Preset& preset) { return preset.own ? ", own" : ""; }

} // namespace

void printPresetsJson(std::span<const Preset> presets)
{
    Json list = Json::array();
    for (const Preset& preset : presets)
        list.push_back(jsonOf(preset));
    print({{"presets", std::move(list)}});
}

void printPresets(std::span<const Preset> presets)
{
    for (const Preset& preset : presets) {
        std::cout << preset.name << " (" << presetKindName(preset.kind) << ownMark(preset)
                  << "): " << preset.label << "\n   ";
        for (const PresetNumber& number : preset.values)
            std::cout << ' ' << number.key << ' ' << withUnitOf(preset, number)
                      << (&number == &preset.values.back() ? "" : ",");
        std::cout << '\n';
        if (!preset.note.empty())
            std::cout << "    " << preset.note << '\n';
    }
    std::cout << "\nripstop-cli presets --show NAME says where each number is from.\n";
}

void printPreset(const Preset& preset)
{
    std::cout << preset.name << " (" << presetKindName(preset.kind) << ownMark(preset)
              << "): " << preset.label << '\n';
    if (!preset.note.empty())
        std::cout << preset.note << '\n';
    for (const PresetNumber& number : numbersOf(preset))
        std::cout << "  " << number.key << ' ' << withUnitOf(preset, number) << ", "
                  << standingName(number.standing) << ": " << number.source << '\n';
    if (!preset.curve.points.empty())
        std::cout << "  stretch at " << curveText(preset) << ", "
                  << standingName(preset.curve.standing) << ": " << preset.curve.source << '\n';
}

void printPresetManual(std::span<const Preset> presets)
{
    std::cout
        << "# The library of materials\n\n"
           "What `ripstop-cli presets` lists, with the source of each number. Made by "
           "`ripstop-cli presets --manual` of\n[materials.json](../resources/materials.json); "
           "do not edit. [Materials](materials.md#presets) says what the words mean.\n";
    for (int kind = 0; kind < presetKindCount; ++kind) {
        constexpr std::array<const char*, presetKindCount> titles{"Fabrics", "Films", "Lines",
                                                                  "Spars"};
        std::cout << "\n## " << titles[std::size_t(kind)] << '\n';
        for (const Preset& preset : presets) {
            if (preset.kind != PresetKind(kind))
                continue;
            std::cout << "\n### " << preset.label << "\n\n`" << preset.name << "`";
            std::cout << (preset.note.empty() ? "" : ". ") << preset.note << "\n\n"
                      << "| number | value | standing | source |\n|---|---|---|---|\n";
            for (const PresetNumber& number : numbersOf(preset))
                std::cout << "| " << number.key << " | " << withUnitOf(preset, number) << " | "
                          << standingName(number.standing) << " | " << number.source << " |\n";
            if (!preset.curve.points.empty())
                std::cout << "| stretch | " << curveText(preset) << " | "
                          << standingName(preset.curve.standing) << " | " << preset.curve.source
                          << " |\n";
        }
    }
}

} // namespace ripstop
