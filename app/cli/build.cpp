// ripstop-cli build and builders: designs from parameters.
//
// In order: the builder is found and its parameters are read (builders/typed_parameters.h);
// buildScene() makes the design and writes it; and listBuilders() prints what builders there are,
// as a text or as JSON.
#include "builders/builder.h"
#include "builders/typed_parameters.h"
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "io/scene_file.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <iostream>

namespace ripstop {
namespace {

std::string names(std::string_view separator)
{
    std::string list;
    for (const Builder& builder : allBuilders())
        list.append(list.empty() ? "" : separator).append(builder.name);
    return list;
}

// The builder of that name, or null after a message has been printed.
const Builder* chooseBuilder(const std::string& name)
{
    if (const Builder* builder = findBuilder(name))
        return builder;
    fail(WrongUsage, "There is no builder \"" + name + "\"; there are " + names(", ") + ".");
    return nullptr;
}

// Parameters that were given and change nothing, because they mean something beside others only:
// the mouth of a parachute is that of pressure inside.
std::vector<std::string> idleOnes(const Builder& builder, const Parameters& given,
                                  const Scene& scene)
{
    const auto withoutParameters = [](Scene one) {
        for (Entry& entry : one.items)
            if (auto* part = std::get_if<Part>(&entry.item))
                part->parameters.clear();
        return one;
    };
    const Scene plain = withoutParameters(scene);
    std::vector<std::string> idle;
    for (const auto& [key, value] : given) {
        Parameters others = given;
        others.erase(key);
        others = newDesign(builder, others);
        const auto row = std::ranges::find(builder.parameters, key, &Parameter::key);
        const auto usual = others.find(key);
        if (row == builder.parameters.end()
            || value == (usual != others.end() ? usual->second : row->initial))
            continue; // it was given what it has anyway, or is a number of a table
        const Result<Scene> other = build(builder, others);
        if (other && withoutParameters(*other) == plain)
            idle.push_back(key);
    }
    return idle;
}

// Says what is offered of a new design, such as materials that one can buy, and is not because of
// numbers of one's own.
void tellIdealOnes(const Builder& builder, const Parameters& design)
{
    for (const Parameter& parameter : builder.parameters) {
        const std::string_view key = parameter.key;
        if (!parameter.offered || design.contains(std::string(key)))
            continue;
        std::cerr << "ripstop-cli: " << key << " is ";
        if (parameter.choices.empty())
            std::cerr << shortNumber(parameter.initial)
                      << ", as the numbers that are given want it, "
                      << "and not " << shortNumber(*parameter.offered) << ".\n";
        else
            std::cerr << "ideal, as the numbers that are given want it; " << key
                      << "=NAME chooses one that can be bought.\n";
    }
}

struct BuildOptions
{
    std::string builder;
    std::vector<std::string> parameters;
    std::vector<std::string> assignments;
    std::string output;
};

int buildScene(const BuildOptions& options)
{
    const Builder* builder = chooseBuilder(options.builder);
    if (!builder)
        return WrongUsage;
    const Result<Parameters> parameters = parametersFrom(*builder, options.parameters);
    if (!parameters)
        return fail(WrongUsage, parameters.message());
    const Parameters design = newDesign(*builder, *parameters);
    Result<Scene> scene = build(*builder, design);
    if (!scene)
        return fail(WrongUsage, scene.message());
    if (const auto cloth = design.find("cloth"); cloth == design.end() || cloth->second != 0.0)
        tellIdealOnes(*builder, design);
    for (const std::string& key : idleOnes(*builder, *parameters, *scene))
        warn(key + " changes nothing of this design; ripstop-cli builders "
             + std::string(builder->name) + " says what each parameter is for.");
    if (const auto failure = assign(*scene, options.assignments))
        return fail(WrongUsage, failure->message);
    if (const auto failure = saveReadable(*scene, options.output))
        return fail(BadInput, failure->message);
    return Done;
}

Json jsonOf(const Builder& builder)
{
    Json parameters = Json::array();
    for (const Parameter& parameter : builder.parameters) {
        parameters.push_back({{"key", parameter.key},
                              {"unit", parameter.unit},
                              {"default", parameter.atFirst()},
                              {"low", parameter.low},
                              {"high", parameter.high},
                              {"whole", parameter.whole},
                              {"help", parameter.help}});
        if (parameter.offered) // what a file means that does not say it
            parameters.back()["unsaid"] = parameter.initial;
        for (const std::string_view choice : parameter.choices)
            parameters.back()["choices"].push_back(choice);
    }
    Json json = {{"name", builder.name},
                 {"label", builder.label},
                 {"help", builder.help},
                 {"parameters", std::move(parameters)}};
    if (builder.table)
        json["table"] = {{"key", builder.table->key},
                         {"unit", builder.table->unit},
                         {"low", builder.table->low},
                         {"high", builder.table->high},
                         {"help", builder.table->help}};
    return json;
}

std::string padded(std::string_view text, std::size_t width)
{
    return std::string(text) + std::string(width - std::min(text.size(), width - 1), ' ');
}

// "mil_7020_1", or "0.47".
std::string defaultOf(const Parameter& parameter)
{
    if (parameter.choices.empty())
        return shortNumber(parameter.atFirst());
    return std::string(parameter.choices[std::size_t(parameter.atFirst())]);
}

void describe(const Builder& builder)
{
    std::cout << builder.name << ": " << builder.help << "\n\n"
              << padded("parameter", 18) << padded("default", 12) << padded("range", 18)
              << padded("unit", 8) << "meaning\n";
    for (const Parameter& parameter : builder.parameters)
        std::cout << padded(parameter.key, 18) << padded(defaultOf(parameter), 12)
                  << padded(shortNumber(parameter.low) + " to " + shortNumber(parameter.high), 18)
                  << padded(parameter.unit.empty() ? (parameter.whole ? "whole" : "1")
                                                   : parameter.unit,
                            8)
                  << parameter.help
                  << (parameter.choices.empty() ? "" : " One of " + listed(parameter.choices) + '.')
                  << '\n';
    const auto isIdealBy = [](const Parameter& p) {
        return p.offered && std::ranges::find(p.choices, "ideal") != p.choices.end();
    };
    if (const auto one = std::ranges::find_if(builder.parameters, isIdealBy);
        one != builder.parameters.end())
        std::cout << "\nWith " << one->key
                  << "=ideal it is the design of the papers: what is not given is then ideal, "
                     "too.\n";
    if (builder.table)
        std::cout << padded(builder.table->key, 18) << padded("none", 12)
                  << padded(shortNumber(builder.table->low) + " to "
                                + shortNumber(builder.table->high),
                            18)
                  << padded(builder.table->unit, 8) << builder.table->help
                  << " Rows end with ; or @FILE names a file.\n";
}

struct BuildersOptions
{
    std::string name;
    bool json = false;
};

int listBuilders(const BuildersOptions& options)
{
    if (!options.name.empty()) {
        const Builder* builder = chooseBuilder(options.name);
        if (!builder)
            return WrongUsage;
        if (options.json)
            print(jsonOf(*builder));
        else
            describe(*builder);
        return Done;
    }
    Json list = Json::array();
    for (const Builder& builder : allBuilders()) {
        list.push_back(jsonOf(builder));
        if (!options.json)
            std::cout << padded(builder.name, 16) << builder.help << '\n';
    }
    if (options.json)
        print({{"builders", std::move(list)}});
    return Done;
}

} // namespace

void addBuild(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand("build", "Make a scene from a parametric design.");
    const auto options = std::make_shared<BuildOptions>();
    command->add_option("BUILDER", options->builder, "One of " + names(", "))->required();
    command->add_option("KEY=VALUE", options->parameters,
                        "Parameters; those left out keep their default");
    command->add_option("-o,--output", options->output, "Scene file to write")
        ->required()
        ->type_name("SCENE");
    addSetOption(*command, options->assignments);
    command->footer(
        "Examples:\n"
        "  ripstop-cli builders delta_kite              (lists the parameters)\n"
        "  ripstop-cli build delta_kite segments=14 span=2.4 -o kite.ripstop.json\n"
        "  ripstop-cli build delta_kite cloth=ideal -o papers.ripstop.json   (as in the "
        "papers)\n"
        "  ripstop-cli build bridle lengths=@lengths.csv -o bridle.ripstop.json\n"
        "  ripstop-cli build parachute rings=8 -o canopy.ripstop.json \\\n"
        "      --set settings.substeps=8");
    command->callback([options, &chosen] { chosen = [options] { return buildScene(*options); }; });
}

void addBuilders(CLI::App& app, Command& chosen)
{
    CLI::App* command =
        app.add_subcommand("builders", "List the designs, or the parameters of one of them.");
    const auto options = std::make_shared<BuildersOptions>();
    command->add_option("BUILDER", options->name, "One of " + names(", "));
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer("Examples:\n"
                    "  ripstop-cli builders\n"
                    "  ripstop-cli builders hang_glider");
    command->callback(
        [options, &chosen] { chosen = [options] { return listBuilders(*options); }; });
}

} // namespace ripstop
