// ripstop-cli schema: what a scene file may have, as JSON Schema, made from the table of
// properties.
//
// In order: the schema of one value; that of a kind of thing with all its properties; and the file.
#include "cli/commands.h"
#include "cli/json_values.h"
#include "scene/property.h"
#include "terminal/terminal.h"

#include <cmath>
#include <iostream>

namespace ripstop {
namespace {

constexpr std::uint32_t highestId = 4000000000;

Json idSchema() { return {{"type", "integer"}, {"minimum", 1}, {"maximum", highestId}}; }

void addRange(Json& schema, const Range& range)
{
    if (std::isfinite(range.low))
        schema[range.openLow ? "exclusiveMinimum" : "minimum"] = range.low;
    if (std::isfinite(range.high))
        schema["maximum"] = range.high;
}

Json listOf(Json items, int count)
{
    Json list = {{"type", "array"}, {"items", std::move(items)}};
    if (count > 0)
        list["minItems"] = list["maxItems"] = count;
    return list;
}

// By the type that the property holds.
Json valueSchema(const Property& property)
{
    struct Writer
    {
        const Property& property;

        Json number(const char* type) const
        {
            Json schema = {{"type", type}};
            addRange(schema, property.range);
            return schema;
        }
        Json operator()(std::monostate) const { return number("number"); } // one that may be absent
        Json operator()(double) const { return number("number"); }
        Json operator()(int) const { return number("integer"); }
        Json operator()(bool) const { return {{"type", "boolean"}}; }
        Json operator()(const std::string&) const
        {
            if (!property.choices.empty())
                return {{"enum", property.choices}};
            Json schema = {{"type", "string"}};
            if (property.meaning == Meaning::Color)
                schema["pattern"] = "^#[0-9a-fA-F]{6}$";
            return schema;
        }
        Json operator()(const Vec3&) const { return listOf({{"type", "number"}}, 3); }
        Json operator()(Id) const { return idSchema(); }
        Json operator()(const std::vector<Id>&) const { return listOf(idSchema(), 0); }
        Json operator()(const NumberRows&) const
        {
            return listOf(listOf({{"type", "number"}}, property.columns), 0);
        }
    };
    return std::visit(Writer{property}, property.initial);
}

Json propertySchema(const Property& property)
{
    Json schema = valueSchema(property);
    schema["title"] = property.label;
    std::string text(property.help);
    if (!property.unit.empty())
        text.append(" In ").append(property.unit).append(".");
    schema["description"] = text;
    const bool hasDefault = !property.optional && property.pointsAt.empty();
    if (hasDefault)
        schema["default"] = jsonOf(property.initial);
    return schema;
}

// The settings have neither type nor id, elements no type.
Json kindSchema(Kind kind)
{
    Json properties = Json::object();
    Json required = Json::array();
    if (!isElement(kind) && kind != Kind::Settings) {
        properties["type"] = {{"const", kindName(kind)}};
        required.push_back("type");
    }
    if (kind != Kind::Settings) {
        properties["id"] = idSchema();
        required.push_back("id");
    }
    for (const Property& property : propertiesOf(kind))
        properties[std::string(property.key)] = propertySchema(property);
    if (kind == Kind::Part) {
        properties["parameters"] = {{"type", "object"},
                                    {"additionalProperties", {{"type", "number"}}},
                                    {"description", "Of the builder, by their names."}};
        for (const Kind element : {Kind::Particle, Kind::Link, Kind::Panel})
            properties[std::string(kindPlural(element))] =
                listOf({{"$ref", "#/$defs/" + std::string(kindName(element))}}, 0);
    }
    Json schema = {{"type", "object"}};
    if (!required.empty())
        schema["required"] = std::move(required);
    schema["additionalProperties"] = false;
    schema["properties"] = std::move(properties);
    return schema;
}

Json fileSchema()
{
    Json kinds = Json::object();
    Json items = Json::array();
    for (int i = 0; i < kindCount; ++i) {
        const std::string name(kindName(Kind(i)));
        kinds[name] = kindSchema(Kind(i));
        if (!isElement(Kind(i)) && Kind(i) != Kind::Settings)
            items.push_back({{"$ref", "#/$defs/" + name}});
    }
    return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"title", "Ripstop scene"},
            {"description", "SI units, y up. What equals its default may be left out, and ids are "
                            "never used twice. Made by `ripstop-cli schema`; do not edit."},
            {"type", "object"},
            {"required", {"format", "version"}},
            {"additionalProperties", false},
            {"properties",
             {{"format", {{"const", "ripstop-scene"}}},
              {"version", {{"const", 1}}},
              {"nextId", idSchema()},
              {"settings", {{"$ref", "#/$defs/settings"}}},
              {"items", listOf({{"oneOf", std::move(items)}}, 0)}}},
            {"$defs", std::move(kinds)}};
}

} // namespace

void addSchema(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "schema", "Print what a scene file may have, as JSON Schema, for editors and checks.");
    command->footer("Example:\n"
                    "  ripstop-cli schema > ripstop-scene.schema.json\n"
                    "\n"
                    "Keys that this version does not know are kept in files, and are no part of "
                    "the schema, so that it\nfinds those that are misspelt.");
    command->callback([&chosen] {
        chosen = [] {
            std::cout << fileSchema().dump(1) << '\n';
            return int(Done);
        };
    });
}

} // namespace ripstop
