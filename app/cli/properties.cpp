// ripstop-cli properties: the manual of all properties, made from their table.
//
// In order: the cells of one property (type, range, default, when it takes effect), the sections by
// kind of thing, the list of quantities of probes, the whole manual as Markdown, and the table as
// JSON. All of it is read from the table of properties, so that the manual cannot lag behind it.
#include "base/quantity.h"
#include "scene/property.h"

#include "cli/commands.h"
#include "cli/json_values.h"
#include "terminal/terminal.h"

#include <cmath>
#include <iostream>

namespace ripstop {
namespace {

std::string typeOf(const Property& property)
{
    constexpr std::array<const char*, 9> names{"number", "true or false", "whole number",
                                               "number", "text",          "three numbers",
                                               "id",     "list of ids",   "rows of numbers"};
    if (property.choices.empty())
        return names[property.initial.index()];
    std::string list;
    for (const std::string_view choice : property.choices)
        list.append(list.empty() ? "`" : ", `").append(choice).append("`");
    return list;
}

std::string rangeOf(const Property& property)
{
    const Range& range = property.range;
    if (std::isfinite(range.low) && std::isfinite(range.high))
        return shortNumber(range.low) + " to " + shortNumber(range.high);
    if (std::isfinite(range.low))
        return (range.openLow ? "above " : "from ") + shortNumber(range.low);
    if (std::isfinite(range.high))
        return "up to " + shortNumber(range.high);
    std::string kinds;
    for (int i = 0; i < kindCount; ++i)
        if (property.pointsAt.contains(Kind(i)))
            kinds.append(kinds.empty() ? "of a " : ", ").append(kindName(Kind(i)));
    return kinds;
}

std::string defaultOf(const Property& property)
{
    if (const auto* number = std::get_if<double>(&property.initial))
        return shortNumber(*number);
    if (const auto* rows = std::get_if<NumberRows>(&property.initial))
        return std::to_string(rows->size()) + " rows";
    if (property.optional)
        return property.kind == Kind::Link ? "the material's" : "none";
    const std::string text = textFromValue(property.initial);
    return !property.pointsAt.empty() ? "none" : text.empty() ? "empty" : text;
}

std::string takesEffect(Effect effect)
{
    switch (effect) {
    case Effect::DisplayOnly:
        return "in the view only";
    case Effect::Recompile:
        return "on the next step";
    case Effect::OnReset:
        return "on reset";
    }
    return {};
}

void addKind(std::string& text, Kind kind)
{
    std::string title(kindName(kind));
    title[0] = char(title[0] - 'a' + 'A');
    text.append("\n## ").append(title).append("\n\n");
    text += "| key | name | unit | default | values | takes effect | meaning |\n"
            "|---|---|---|---|---|---|---|\n";
    for (const Property& property : propertiesOf(kind)) {
        const std::string range = rangeOf(property);
        text.append("| `").append(property.key).append("` | ").append(property.label);
        text.append(" | ").append(property.unit).append(" | ").append(defaultOf(property));
        text.append(" | ").append(typeOf(property)).append(range.empty() ? "" : ", " + range);
        text.append(" | ").append(takesEffect(property.effect));
        text.append(" | ").append(property.help).append(" |\n");
    }
}

void addQuantities(std::string& text)
{
    const auto measuredOn = [](const QuantityRow& row) -> std::string_view {
        if (row.points > 1)
            return row.points == 2 ? "two particles" : "three particles";
        switch (row.of) {
        case QuantityRow::Of::Particles:
            return "particles";
        case QuantityRow::Of::Links:
            return "links";
        case QuantityRow::Of::LinksAndPanels:
            return "links and panels";
        case QuantityRow::Of::Fabric:
        case QuantityRow::Of::Panels:
            return "panels";
        case QuantityRow::Of::Canopy:
            return "a canopy";
        case QuantityRow::Of::Whole:
            return "the scene";
        case QuantityRow::Of::Probes:
            return "other probes";
        }
        return {};
    };
    text += "\n## What probes measure\n\n"
            "| quantity | unit | on | meaning |\n"
            "|---|---|---|---|\n";
    for (std::size_t i = 0; i < choiceNames<Quantity>.size(); ++i) {
        const QuantityRow& row = rowOf(Quantity(i));
        text.append("| `").append(choiceNames<Quantity>[i]).append("` | ").append(row.unit);
        text.append(" | ").append(measuredOn(row)).append(" | ").append(row.help).append(" |\n");
    }
}

std::string manual()
{
    std::string text =
        "# Properties\n\n"
        "Everything that can be set in a scene, by the keys that files, `--set` and the inspector "
        "use.\nMade by `ripstop-cli properties`; do not edit.\n\n"
        "SI units; y is up. A value that equals its default is left out of files. In `--set` a "
        "property is\nnamed by a path:\n\n"
        "| path | means |\n|---|---|\n"
        "| `settings.timeStep` | a setting |\n"
        "| `wind.velocity` | a property of the item of that name |\n"
        "| `#17.mass` | a property of the item or element with that id |\n"
        "| `kite.particles.mass` | a property of all particles (or links, or panels) of a part |\n";
    for (int i = 0; i < kindCount; ++i)
        addKind(text, Kind(i));
    addQuantities(text);
    return text;
}

Json table()
{
    Json list = Json::array();
    for (const Property& property : allProperties()) {
        Json entry = {{"kind", kindName(property.kind)},
                      {"key", property.key},
                      {"label", property.label},
                      {"unit", property.unit},
                      {"type", typeOf(property)},
                      {"default", jsonOf(property.initial)},
                      {"optional", property.optional},
                      {"low", property.range.low},
                      {"high", property.range.high},
                      {"low_excluded", property.range.openLow},
                      {"choices", Json::array()},
                      {"effect", takesEffect(property.effect)},
                      {"help", property.help}};
        if (!property.choices.empty())
            entry["type"] = "choice";
        for (const std::string_view choice : property.choices)
            entry["choices"].push_back(choice);
        list.push_back(std::move(entry));
    }
    return {{"properties", std::move(list)}};
}

} // namespace

void addProperties(CLI::App& app, Command& chosen)
{
    CLI::App* command =
        app.add_subcommand("properties", "Print the manual of all properties, as Markdown.");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print one JSON object instead");
    command->footer("Examples:\n"
                    "  ripstop-cli properties | less\n"
                    "  ripstop-cli properties --json");
    command->callback([json, &chosen] {
        chosen = [json] {
            if (*json)
                print(table());
            else
                std::cout << manual();
            return int(Done);
        };
    });
}

} // namespace ripstop
