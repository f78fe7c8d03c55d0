// readMaterials() checks the head of the file, then each material: name and kind, its numbers in
// the order of the table of properties, its curve, and whether a cloth can be like that. What is
// wrong is a Failure that the reader of the whole completes with the file and the material.
// nlohmann's exceptions are met here and go no further.
//
// A number is divided by a whole number where its unit is a part of the SI unit (27 g/m^2 is
// 27 / 1000), so that it is the same double as 0.027.
#include "materials/material_file.h"

#include "scene/typed_number.h"
#include "scene/units.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* formatName = "ripstop-materials";
constexpr int newestVersion = 1;
constexpr std::array<std::string_view, 4> yarnNames{"", "nylon", "polyester", "polyethylene"};

std::string listOf(std::span<const std::string_view> names)
{
    std::string list;
    for (const std::string_view name : names)
        if (!name.empty())
            list.append(list.empty() ? "" : ", ").append(name);
    return list;
}

template <typename Enum, std::size_t count>
std::optional<Enum> enumOf(std::string_view name, const std::array<std::string_view, count>& names)
{
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : std::optional(Enum(found - names.begin()));
}

template <auto nameOf, typename Enum, int count>
std::array<std::string_view, count> namesOf()
{
    std::array<std::string_view, count> names;
    for (int i = 0; i < count; ++i)
        names[std::size_t(i)] = nameOf(Enum(i));
    return names;
}
const auto kinds = namesOf<presetKindName, PresetKind, presetKindCount>();
const auto standings = namesOf<standingName, NumberStanding, numberStandingCount>();

// The text of a key, empty where there is none; nothing where it is no text.
std::optional<std::string> textAt(const Json& object, const char* key)
{
    const auto found = object.find(key);
    if (found == object.end())
        return std::string();
    return found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}

// Units are few, and each costs an expression to work out.
std::optional<double> factorOf(const std::string& unit, const std::string& wanted)
{
    thread_local std::map<std::pair<std::string, std::string>, std::optional<double>> known;
    const auto [place, isNew] = known.try_emplace({unit, wanted});
    if (isNew)
        place->second = unitFactor(unit, wanted);
    return place->second;
}

double converted(double number, double factor)
{
    const double parts = std::round(1.0 / factor);
    return factor < 1.0 && std::abs(parts * factor - 1.0) < 1e-12 ? number / parts
                                                                  : number * factor;
}

// --- reading one material ---------------------------------------------------------------------

using Sources = std::map<std::string, std::string>;

class MaterialReader
{
public:
    MaterialReader(const Json& object, const Sources& sources)
        : m_object(object)
        , m_sources(sources)
    {}

    Result<Preset> read()
    {
        for (const auto step :
             {&MaterialReader::readHead, &MaterialReader::readNumbers, &MaterialReader::readCurve})
            if (const auto failure = (this->*step)())
                return *failure;
        if (const auto why = implausible(m_preset))
            return Failure(*why);
        return m_preset;
    }

private:
    using Outcome = std::optional<Failure>;

    Outcome readHead()
    {
        const auto kind = textAt(m_object, "kind"), label = textAt(m_object, "label"),
                   note = textAt(m_object, "note"), yarn = textAt(m_object, "yarn"),
                   shortLabel = textAt(m_object, "short");
        if (!kind || !label || !shortLabel || !note || !yarn)
            return Failure("kind, label, short, note and yarn must be texts.");
        const auto knownKind = enumOf<PresetKind>(*kind, kinds);
        if (!knownKind)
            return Failure("The kind must be one of %1.", listOf(kinds));
        const auto knownYarn = enumOf<Yarn>(*yarn, yarnNames);
        if (!knownYarn)
            return Failure("The yarn must be one of %1, or left out.", listOf(yarnNames));
        m_preset.kind = *knownKind;
        m_preset.yarn = *knownYarn;
        m_preset.name = *textAt(m_object, "name");
        m_preset.label = label->empty() ? m_preset.name : *label;
        m_preset.shortLabel = *shortLabel;
        m_preset.note = *note;
        return std::nullopt;
    }

    Outcome readNumbers()
    {
        const auto numbers = m_object.find("numbers");
        if (numbers == m_object.end() || !numbers->is_object() || numbers->empty())
            return Failure("It needs \"numbers\", an object with at least one of them.");
        Material example; // its tear rule says what the tear limit is measured in
        std::vector<std::string_view> known{breakElongationKey};
        for (const Property& property : propertiesOf(Kind::Material))
            if (isPhysical(property))
                known.push_back(property.key);
        for (const auto& [key, object] : numbers->items()) {
            if (std::ranges::find(known, key) != known.end())
                continue;
            const std::string_view near = nearest(key, known);
            return near.empty()
                       ? Failure("There is no number \"%1\"; there are %2.", key, listOf(known))
                       : Failure("There is no number \"%1\"; did you mean \"%2\"?", key, near);
        }
        for (const Property& property : propertiesOf(Kind::Material)) {
            const auto object = numbers->find(std::string(property.key));
            if (object == numbers->end() || !isPhysical(property))
                continue;
            Result<PresetNumber> number = readNumber(
                *object, property.key, std::string(unitOf(Scene(), property, &example)), &property);
            if (!number)
                return number.failure();
            property.set(&example, number->value);
            m_preset.values.push_back(std::move(*number));
        }
        if (const auto object = numbers->find(std::string(breakElongationKey));
            object != numbers->end()) {
            Result<PresetNumber> number = readNumber(*object, breakElongationKey, {}, nullptr);
            if (!number)
                return number.failure();
            m_preset.breakElongation = std::move(*number);
        }
        return std::nullopt;
    }

    Result<PresetNumber> readNumber(const Json& object, std::string_view key,
                                    const std::string& wanted, const Property* property) const
    {
        PresetNumber number{key, {}, {}, {}};
        if (!object.is_object() || !object.contains("value"))
            return Failure("%1 needs an object with value, unit, standing and source.", key);
        const Json& value = object["value"];
        if (property && !property->choices.empty()) {
            if (!value.is_string())
                return Failure("%1 must be one of %2.", key, listOf(property->choices));
            number.value = value.get<std::string>();
        } else {
            const auto unit = textAt(object, "unit");
            if (!value.is_number() || !unit)
                return Failure("%1 needs a number as its value and a text as its unit.", key);
            if (unit->empty() && !wanted.empty())
                return Failure("%1 needs its unit, %2 or one that measures the same.", key, wanted);
            const auto factor = factorOf(*unit, wanted);
            if (!factor)
                return Failure("%1 cannot be in %2; it is measured in %3.", key, *unit,
                               wanted.empty() ? "%" : wanted);
            number.value = converted(value.get<double>(), *factor);
        }
        if (property)
            if (const auto why = refusal(*property, number.value))
                return Failure("%1 %2.", key, *why);
        if (const auto why = readStanding(object, key, number.standing, number.source))
            return *why;
        return number;
    }

    Outcome readStanding(const Json& object, std::string_view key, NumberStanding& standing,
                         std::string& source) const
    {
        const auto word = textAt(object, "standing"), named = textAt(object, "source"),
                   how = textAt(object, "how");
        const auto known = word ? enumOf<NumberStanding>(*word, standings) : std::nullopt;
        if (!known)
            return Failure("%1 needs its standing, one of %2.", key, listOf(standings));
        if (!named || named->empty() || !how)
            return Failure("%1 needs its source: who says so, or how it was found.", key);
        standing = *known;
        const auto listed = m_sources.find(*named);
        source = listed == m_sources.end() ? *named : listed->second;
        if (!how->empty())
            source += "; " + *how;
        return std::nullopt;
    }

    Outcome readCurve()
    {
        const auto curve = m_object.find("curve");
        if (curve == m_object.end())
            return std::nullopt;
        const std::string wanted = isSheet(m_preset.kind) ? "N/m" : "N";
        const auto loadUnit = textAt(*curve, "loadUnit"), strainUnit = textAt(*curve, "strainUnit");
        const auto load = loadUnit ? factorOf(*loadUnit, wanted) : std::nullopt;
        const auto strain = strainUnit ? factorOf(*strainUnit, "") : std::nullopt;
        if (!load || loadUnit->empty() || !strain)
            return Failure("The curve needs a loadUnit like %1 and a strainUnit like %2.", wanted,
                           "%");
        const auto points = curve->find("points");
        if (points == curve->end() || !points->is_array())
            return Failure("The curve needs points: pairs of load and strain.");
        StretchPoint last{0.0, 0.0};
        for (const Json& point : *points) {
            if (!point.is_array() || point.size() != 2 || !point[0].is_number()
                || !point[1].is_number())
                return Failure("Each point of the curve is a pair of numbers, load and strain.");
            const StretchPoint next{converted(point[0].get<double>(), *load),
                                    converted(point[1].get<double>(), *strain)};
            if (!(next.load > last.load && next.strain > last.strain))
                return Failure("Loads and strains of the curve must rise from point to point.");
            m_preset.curve.points.push_back(last = next);
        }
        return readStanding(*curve, "curve", m_preset.curve.standing, m_preset.curve.source);
    }

    const Json& m_object;
    const Sources& m_sources;
    Preset m_preset;
};

// --- writing ----------------------------------------------------------------------------------

Json jsonOf(const PresetNumber& number, const std::string& unit)
{
    Json object = Json::object();
    if (const auto* value = std::get_if<double>(&number.value)) {
        object["value"] = *value;
        object["unit"] = unit;
    } else {
        object["value"] = textFromValue(number.value);
    }
    object["standing"] = standingName(number.standing);
    object["source"] = number.source;
    return object;
}

Json jsonOf(const Preset& preset)
{
    Json object{
        {"name", preset.name}, {"label", preset.label}, {"kind", presetKindName(preset.kind)}};
    if (!preset.shortLabel.empty())
        object["short"] = preset.shortLabel;
    if (preset.yarn != Yarn::Unknown)
        object["yarn"] = yarnNames[std::size_t(preset.yarn)];
    if (!preset.note.empty())
        object["note"] = preset.note;
    Json& numbers = object["numbers"] = Json::object();
    for (const PresetNumber& number : preset.values)
        numbers[std::string(number.key)] = jsonOf(number, std::string(unitOf(preset, number)));
    if (preset.breakElongation)
        numbers[std::string(breakElongationKey)] = jsonOf(*preset.breakElongation, "");
    if (!preset.curve.points.empty()) {
        Json points = Json::array();
        for (const StretchPoint& point : preset.curve.points)
            points.push_back(Json::array({point.load, point.strain}));
        object["curve"] = {{"loadUnit", isSheet(preset.kind) ? "N/m" : "N"},
                           {"strainUnit", ""},
                           {"points", std::move(points)},
                           {"standing", standingName(preset.curve.standing)},
                           {"source", preset.curve.source}};
    }
    return object;
}

Json emptyFile()
{
    return {{"format", formatName}, {"version", newestVersion}, {"materials", Json::array()}};
}

std::string textOf(const Json& file) { return file.dump(2) + '\n'; }

// Line and column of a byte, from 1.
std::pair<std::size_t, std::size_t> placeOf(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = std::size_t(std::ranges::count(before, '\n')) + 1;
    const std::size_t start = before.rfind('\n');
    return {line, before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1};
}

Result<Json> parsed(std::string_view text, std::string_view name)
{
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto [line, column] = placeOf(text, error.byte);
        return Failure("%1, line %2, column %3: This is not JSON; look for a comma, a quotation "
                       "mark or a bracket that is missing or too much there.",
                       name, line, column);
    } catch (const Json::exception&) {
        return Failure("%1: A number in it is too large to be read.", name);
    }
}

Result<Sources> sourcesIn(const Json& file, std::string_view name)
{
    Sources sources;
    const auto list = file.find("sources");
    if (list == file.end())
        return sources;
    for (const auto& [key, text] : list->items()) {
        if (!text.is_string())
            return Failure("%1: The source \"%2\" must be a text.", name, key);
        sources[key] = text.get<std::string>();
    }
    return sources;
}

std::optional<Failure> wrongHead(const Json& file, std::string_view name)
{
    if (!file.is_object() || textAt(file, "format") != formatName)
        return Failure("%1: This is no file of materials; those begin with \"format\": \"%2\".",
                       name, formatName);
    const auto version = file.find("version");
    if (version == file.end() || !version->is_number_integer() || *version > newestVersion)
        return Failure("%1: Its version is not %2; a newer Ripstop may read it.", name,
                       newestVersion);
    const auto materials = file.find("materials");
    if (materials == file.end() || !materials->is_array())
        return Failure("%1: It needs \"materials\", a list of them.", name);
    return std::nullopt;
}

} // namespace

Result<std::vector<Preset>> readMaterials(std::string_view text, std::string_view name)
{
    const Result<Json> file = parsed(text, name);
    if (!file)
        return file.failure();
    if (const auto failure = wrongHead(*file, name))
        return *failure;
    const Result<Sources> sources = sourcesIn(*file, name);
    if (!sources)
        return sources.failure();
    std::vector<Preset> presets;
    int number = 0;
    for (const Json& object : (*file)["materials"]) {
        ++number;
        const auto called = object.is_object() ? textAt(object, "name") : std::nullopt;
        if (!called || called->empty())
            return Failure("%1: Material %2 of the list has no name.", name, number);
        Result<Preset> preset = MaterialReader(object, *sources).read();
        if (!preset)
            return Failure("%1, material %2: %3", name, *called, preset.message());
        if (std::ranges::find(presets, *called, &Preset::name) != presets.end())
            return Failure("%1: Two materials are called %2; give one another name.", name,
                           *called);
        presets.push_back(std::move(*preset));
    }
    return presets;
}

std::string materialsText(const std::vector<Preset>& presets)
{
    Json file = emptyFile();
    for (const Preset& preset : presets)
        file["materials"].push_back(jsonOf(preset));
    return textOf(file);
}

std::string withMaterial(std::string_view text, const Preset& preset)
{
    Json file = text.empty() ? emptyFile() : Json::parse(text);
    Json& materials = file["materials"];
    const auto old = std::ranges::find_if(
        materials, [&](const Json& object) { return textAt(object, "name") == preset.name; });
    if (old == materials.end())
        materials.push_back(jsonOf(preset));
    else
        *old = jsonOf(preset);
    return textOf(file);
}

} // namespace ripstop
