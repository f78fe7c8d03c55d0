// ripstop-cli polar: what an air law does to a flat plate, beside published curves.
//
// The subject is the name of a law, for which a scene with one material is made, or a scene file
// with a material in it. The rows of the polar are then printed as JSON, as CSV or as a table.
#include "measure/polar.h"

#include "cli/commands.h"
#include "cli/scene_input.h"
#include "compile/resolve.h"
#include "scene/path.h"
#include "scene/property.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace ripstop {
namespace {

struct PolarOptions
{
    std::string subject; // a law or a scene file
    std::string material;
    std::vector<std::string> assignments;
    double step = 5.0; // degrees
    bool json = false;
    bool csv = false;
};

std::string lawNames()
{
    std::string list;
    for (const std::string_view name : choiceNames<AirLaw>)
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

// A scene with one material of this law, called "plate".
Scene plateOf(std::string_view law)
{
    Material plate;
    plate.name = "plate";
    const auto& names = choiceNames<AirLaw>;
    plate.airLaw = AirLaw(std::find(names.begin(), names.end(), law) - names.begin());
    plate.skinFriction = 0.0;
    if (plate.airLaw == AirLaw::Paper)
        plate.normalCoefficient = 4.0;
    if (plate.airLaw == AirLaw::Vortex)
        plate.broadsideCoefficient = 1.17; // of a plate that has stalled
    Scene scene;
    const Id id = takeId(scene);
    scene.items.push_back({id, plate});
    return scene;
}

// The material of that name; any name will do where there is a single material.
Result<MaterialAir> airIn(const Scene& scene, const std::string& name)
{
    std::string list;
    int count = 0;
    for (const Entry& entry : scene.items)
        if (const Material* material = std::get_if<Material>(&entry.item)) {
            list += (list.empty() ? "" : ", ") + material->name;
            ++count;
        }
    if (count == 0)
        return Failure{"the scene has no material; give a law instead"};
    if (name.empty() && count > 1)
        return Failure("name a material with --material; there is %1", list);
    const Result<Id> id = findNamed(scene, Kind::Material, name.empty() ? list : name);
    if (!id)
        return id.failure();
    return airOf(*id, *findItem<Material>(scene, *id));
}

void printJson(const std::vector<PolarRow>& rows)
{
    Json object = {{"rows", Json::array()}, {"references", Json::array()}};
    for (const PolarRow& row : rows)
        object["rows"].push_back(
            {{"angle", row.degrees}, {"CN", row.normal}, {"CL", row.lift}, {"CD", row.drag}});
    for (const PolarReference& reference : polarReferences()) {
        Json entry = {{"key", reference.key}, {"name", reference.name}, {"CN", Json::array()}};
        for (const PolarRow& row : rows)
            entry["CN"].push_back(row.degrees <= reference.last
                                      ? Json(rowOf(reference, row.degrees).normal)
                                      : Json());
        object["references"].push_back(std::move(entry));
    }
    print(object);
}

void printTable(const std::vector<PolarRow>& rows, bool csv)
{
    std::string text = csv ? "angle,CN,CL,CD" : " angle      CN      CL      CD ";
    char cell[40];
    for (const PolarReference& reference : polarReferences()) {
        std::snprintf(cell, sizeof cell, csv ? ",%s" : " %14s", std::string(reference.key).c_str());
        text += cell;
    }
    text += '\n';
    for (const PolarRow& row : rows) {
        char start[120];
        std::snprintf(start, sizeof start,
                      csv ? "%.10g,%.10g,%.10g,%.10g" : "%6g %7.3f %7.3f %7.3f ", row.degrees,
                      row.normal, row.lift, row.drag);
        text += start;
        for (const PolarReference& reference : polarReferences()) {
            const double normal = rowOf(reference, row.degrees).normal;
            if (row.degrees > reference.last)
                std::snprintf(cell, sizeof cell, csv ? "," : " %14s", "-");
            else
                std::snprintf(cell, sizeof cell, csv ? ",%.10g" : " %14.3f", normal);
            text += cell;
        }
        text += '\n';
    }
    std::cout << text;
    if (csv)
        return;
    std::cout << "\nC_N of published curves:\n";
    for (const PolarReference& reference : polarReferences())
        std::cout << "  " << std::string(reference.key) << ": " << reference.name << '\n';
}

int printPolar(const PolarOptions& options)
{
    const auto& names = choiceNames<AirLaw>;
    const bool isLaw = std::find(names.begin(), names.end(), options.subject) != names.end();
    Scene scene;
    if (isLaw) {
        scene = plateOf(options.subject);
        if (const auto failure = assign(scene, options.assignments))
            return fail(WrongUsage, failure->message);
    } else {
        if (!std::filesystem::exists(options.subject))
            return fail(BadInput, "\"" + options.subject + "\" is neither a law (" + lawNames()
                                      + ") nor a scene file");
        SceneOutcome outcome = loadScene({options.subject, options.assignments});
        if (!outcome.scene)
            return outcome.exitCode;
        scene = std::move(*outcome.scene);
    }
    const Result<MaterialAir> air = airIn(scene, options.material);
    if (!air)
        return fail(BadInput, air.message());
    const std::vector<PolarRow> rows = platePolar(*air, options.step);
    if (options.json)
        printJson(rows);
    else
        printTable(rows, options.csv);
    return Done;
}

} // namespace

void addPolar(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "polar", "Print C_N, C_L and C_D of an air law on a flat plate, beside published curves.");
    const auto options = std::make_shared<PolarOptions>();
    command->add_option("subject", options->subject, "A law (" + lawNames() + "), or a scene file")
        ->required()
        ->option_text("LAW|SCENE");
    command->add_option("--material", options->material, "Name of a material of the scene")
        ->option_text("NAME");
    addSetOption(*command, options->assignments);
    command->add_option("--step", options->step, "Degrees between rows")
        ->check(numberBetween(0.01, 90.0))
        ->option_text("DEG");
    auto* json = command->add_flag("--json", options->json, "Print one JSON object");
    command->add_flag("--csv", options->csv, "Print comma-separated values")->excludes(json);
    command->footer("A law is shown on a material called plate:\n"
                    "  ripstop-cli polar linear_normal --set plate.normalCoefficient=2.44 \\\n"
                    "      --set plate.broadsideCoefficient=1.17\n"
                    "  ripstop-cli polar lift_drag --step 2 --csv > plate.csv\n"
                    "  ripstop-cli polar scenes/delta_kite.ripstop.json --material sail");
    command->callback([options, &chosen] { chosen = [options] { return printPolar(*options); }; });
}

} // namespace ripstop
