// ripstop-cli info: what is in a scene, and what is wrong with it.
//
// Sums of mass, moment and area are taken over each part; describe() collects all that is said in
// JSON, which printTable() prints for people, so that both outputs say the same.
#include "check/check.h"
#include "check/step_check.h"
#include "cli/commands.h"
#include "cli/replay.h"
#include "cli/scene_input.h"
#include "compile/compile.h"
#include "derived/cloth_area.h"
#include "io/recording_file.h"
#include "step/solver_plan.h"
#include "terminal/terminal.h"

#include <Eigen/Geometry>

#include <iostream>

namespace ripstop {
namespace {

struct Sums
{
    std::size_t particles = 0;
    std::size_t pins = 0;
    std::size_t rods = 0;
    std::size_t springs = 0;
    std::size_t panels = 0;
    double mass = 0.0;          // kg
    Vec3 moment = Vec3::Zero(); // kg m
    double area = 0.0;          // m^2
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

Sums sumsOf(const Scene& scene, const Part& part)
{
    Sums sums;
    sums.particles = part.particles.size();
    sums.panels = part.panels.size();
    for (const Particle& particle : part.particles) {
        sums.pins += particle.pinned ? 1 : 0;
        sums.mass += particle.mass;
        sums.moment += particle.mass * particle.position;
        sums.low = sums.low.cwiseMin(particle.position);
        sums.high = sums.high.cwiseMax(particle.position);
    }
    for (const Link& link : part.links)
        ++(link.kind == LinkKind::Rod ? sums.rods : sums.springs);
    sums.area = ClothArea(part, &scene).whole();
    return sums;
}

Json jsonOf(const Sums& sums)
{
    return {{"particles", sums.particles},
            {"pins", sums.pins},
            {"links", sums.rods + sums.springs},
            {"rods", sums.rods},
            {"springs", sums.springs},
            {"panels", sums.panels},
            {"mass", sums.mass},
            {"fabric_area", sums.area}};
}

Json describe(const Scene& scene)
{
    Sums all;
    Json parts = Json::array();
    forEachPart(scene, [&](Id id, const Part& part) {
        const Sums sums = sumsOf(scene, part);
        Json entry = {{"name", part.name}, {"id", std::uint32_t(id)}};
        entry.update(jsonOf(sums));
        parts.push_back(std::move(entry));
        all.particles += sums.particles;
        all.pins += sums.pins;
        all.rods += sums.rods;
        all.springs += sums.springs;
        all.panels += sums.panels;
        all.mass += sums.mass;
        all.moment += sums.moment;
        all.area += sums.area;
        all.low = all.low.cwiseMin(sums.low);
        all.high = all.high.cwiseMax(sums.high);
    });

    Json info = {{"title", scene.settings.title}};
    info.update(jsonOf(all));
    info["center_of_gravity"] = all.mass > 0.0 ? numbersOf(all.moment / all.mass) : Json();
    info["bounds"] = all.particles > 0
                         ? Json{{"low", numbersOf(all.low)}, {"high", numbersOf(all.high)}}
                         : Json();
    info["time_step"] = scene.settings.timeStep;
    info["substeps"] = scene.settings.substeps;
    info["solver"] = choiceNames<Solver>[std::size_t(scene.settings.solver)];
    info["solver_choice"] = Json();
    if (scene.settings.solver == Solver::Auto)
        if (const auto system = compile(scene))
            info["solver_choice"] = planFor(**system).reason.english();
    const std::optional<StepLimit> limit = stepLimit(scene);
    info["stable_substep"] = limit ? Json(limit->timeStep) : Json();
    info["stable_time_step"] = limit ? Json(limit->timeStep * scene.settings.substeps) : Json();
    info["limited_by"] = limit ? Json(limit->cause.said().english()) : Json();
    info["parts"] = std::move(parts);
    info["problems"] = Json::array();
    for (const Finding& problem : problemsOf(scene))
        info["problems"].push_back(
            {{"severity", problem.severity == Severity::Error ? "error" : "warning"},
             {"message", problem.message.english()},
             {"id", problem.culprits.empty() ? Json() : Json(std::uint32_t(problem.culprit()))}});
    return info;
}

std::string textOf(const Json& vector)
{
    if (vector.is_null())
        return "none";
    std::string text;
    for (const double number : vector)
        text += (text.empty() ? "" : ", ") + shortNumber(number);
    return text;
}

void printTable(const Json& info)
{
    const auto row = [](const std::string& label, const std::string& text) {
        std::cout << label << std::string(20 - std::min<std::size_t>(label.size(), 19), ' ') << text
                  << '\n';
    };
    const auto count = [&](const char* key) { return std::to_string(info[key].get<long>()); };
    row("title", info["title"].get<std::string>());
    row("particles", count("particles") + " (" + count("pins") + " pinned)");
    row("links",
        count("links") + " (" + count("rods") + " rods, " + count("springs") + " springs)");
    row("panels", count("panels"));
    row("mass", shortNumber(info["mass"]) + " kg");
    row("centre of gravity", textOf(info["center_of_gravity"]) + " m");
    row("fabric area", shortNumber(info["fabric_area"]) + " m^2");
    if (!info["bounds"].is_null())
        row("bounds",
            textOf(info["bounds"]["low"]) + " to " + textOf(info["bounds"]["high"]) + " m");
    const bool chosen = !info["solver_choice"].is_null(); // with substeps of its own
    row("time step", shortNumber(info["time_step"]) + " s"
                         + (chosen ? "" : " in " + count("substeps") + " substeps"));
    row("rod solver", info["solver"].get<std::string>()
                          + (chosen ? ": " + info["solver_choice"].get<std::string>() : ""));
    if (!info["stable_time_step"].is_null())
        row("stable up to", shortNumber(info["stable_time_step"]) + " s, for "
                                + info["limited_by"].get<std::string>()
                                + " at this number of substeps");
    for (const Json& part : info["parts"])
        row("part " + part["name"].get<std::string>(),
            std::to_string(part["particles"].get<long>()) + " particles, "
                + std::to_string(part["links"].get<long>()) + " links, "
                + std::to_string(part["panels"].get<long>()) + " panels, "
                + shortNumber(part["mass"]) + " kg");
    if (info["problems"].empty())
        row("problems", "none");
    for (const Json& problem : info["problems"])
        row(problem["severity"].get<std::string>(), problem["message"].get<std::string>());
}

struct InfoOptions
{
    SceneInput scene;
    bool json = false;
};

int info(const InfoOptions& options)
{
    if (options.scene.file.ends_with(recordingExtension))
        return describeRecording(options.scene.file, options.json);
    const SceneOutcome loaded = loadScene(options.scene);
    if (!loaded.scene)
        return loaded.exitCode;
    const Json description = describe(*loaded.scene);
    if (options.json)
        print(description);
    else
        printTable(description);
    return Done;
}

} // namespace

void addInfo(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "info", "Count, weigh and check a scene: particles, links, panels, mass, problems.");
    const auto options = std::make_shared<InfoOptions>();
    addSceneOption(*command, options->scene);
    addSetOption(*command, options->scene.assignments);
    command->add_flag("--json", options->json, "Print one JSON object");
    command->footer(
        "Examples:\n"
        "  ripstop-cli info scenes/delta_kite.ripstop.json\n"
        "  ripstop-cli info kite.ripstop.json --json | jq .mass\n"
        "  ripstop-cli info flight.ripstop-run\n"
        "\n"
        "A scene with errors can be inspected, but not run: they are listed at the end.");
    command->callback([options, &chosen] { chosen = [options] { return info(*options); }; });
}

} // namespace ripstop
