// In order: options that commands share; what --set changes; saving what can be read again; and the
// scene of a command, with what this version does not know of it.
#include "cli/scene_input.h"

#include "check/check.h"
#include "check/unknown.h"
#include "io/json_text.h"
#include "io/scene_file.h"
#include "io/wind_record.h"
#include "scene/path.h"
#include "scene/typed_number.h"
#include "simulation/simulation.h"
#include "study/point_scene.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>

namespace ripstop {
namespace {

constexpr std::size_t mostNamed = 20; // items, one in a line

} // namespace

void addSceneOption(CLI::App& command, SceneInput& input)
{
    command.add_option("SCENE", input.file, "Scene file, *.ripstop.json")->required();
}

CLI::Validator numberBetween(double low, double high)
{
    return {[low, high](std::string& text) -> std::string {
                double value = 0.0;
                const char* const last = text.data() + text.size();
                const auto [end, error] = std::from_chars(text.data(), last, value);
                if (error == std::errc() && end == last && value >= low && value <= high)
                    return {};
                return "must be a number from " + shortNumber(low) + " to " + shortNumber(high)
                       + ", not " + text;
            },
            ""};
}

CLI::Validator quantityBetween(double low, double high, std::string_view unit)
{
    return {[low, high, unit](std::string& text) -> std::string {
                const Typed typed = typedValue(text, unit, ThreeDigits::AreRefused);
                if (!typed.number && typedValue(text, unit).number) // a comma
                    return typed.complaint.english() + ", not " + text;
                if (!typed.number || typed.number->number < low || typed.number->number > high)
                    return "must be a number from " + shortNumber(low) + " to " + shortNumber(high)
                           + ' ' + std::string(unit) + ", not " + text;
                text = numberText(typed.number->number);
                return {};
            },
            ""};
}

CLI::Validator secondsBetween(double low, double high) { return quantityBetween(low, high, "s"); }

void addThreadsOption(CLI::App& command, int& threads)
{
    threads = Simulation::mostThreads();
    command
        .add_option(
            "--threads", threads,
            "Threads, as many as there are cores when it is left out; small designs take one, "
            "and the result is the same for all")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
}

void addSetOption(CLI::App& command, std::vector<std::string>& assignments)
{
    command
        .add_option("--set", assignments,
                    "Change a property for this call: settings.timeStep=0.002, "
                    "\"wind.velocity=6, 0, 0\", wind.velocity.x=6, wind.velocities=@measured.csv, "
                    "kite.particles.mass=0.01, \"#17.mass=0.5\", or build its part again: "
                    "kite.built.span=2; "
                    "may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
}

// "wind.velocities=@FILE" with what the file holds; what is no table of times stays as it is.
Result<std::string> withFile(const Scene& scene, const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || assignment.compare(equals + 1, 1, "@") != 0)
        return assignment;
    const Result<Place> place = findPlace(scene, assignment.substr(0, equals));
    if (!place || place->property->meaning != Meaning::Times)
        return assignment;
    const Result<NumberRows> rows = windRecordOf(assignment.substr(equals + 2));
    if (!rows)
        return rows.failure();
    return assignment.substr(0, equals + 1) + textFromValue(*rows);
}

std::optional<Failure> assign(Scene& scene, const std::vector<std::string>& assignments)
{
    if (assignments.empty())
        return std::nullopt; // large scenes are not copied in vain
    if (const auto controls = std::ranges::find_if(assignments, setsControls);
        controls != assignments.end())
        return Failure("--set %1: controls are no property; run and sweep take the file with "
                       "--controls.",
                       *controls);
    std::vector<std::string> read;
    for (const std::string& assignment : assignments) {
        Result<std::string> text = withFile(scene, assignment);
        if (!text)
            return Failure("--set %1", text.message());
        read.push_back(std::move(*text));
    }
    auto made = sceneWith(scene, read);
    if (!made)
        return Failure("--set %1", made.message());
    scene = std::move(*made);
    return std::nullopt;
}

std::optional<Failure> saveReadable(const Scene& scene, const std::string& file)
{
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (const Result<Scene> again = parseScene(sceneText(scene, folder), file); !again)
        return Failure("%1 was not saved, because it could not be read again; correct what --set "
                       "has changed. %2",
                       file, again.message());
    return saveScene(scene, file);
}

SceneOutcome loadScene(const SceneInput& input)
{
    Result<Scene> scene = readScene(input.file);
    if (!scene)
        return {std::nullopt, fail(BadInput, scene.message())};
    const std::vector<UnknownItem>& unknown = scene->unknownItems;
    for (std::size_t i = 0; i < std::min(unknown.size(), mostNamed); ++i)
        std::cerr << "ripstop-cli: " << input.file << ": " << unknownText(unknown[i]).english()
                  << '\n';
    if (unknown.size() > mostNamed)
        std::cerr << "ripstop-cli: " << input.file << ": so are " << unknown.size() - mostNamed
                  << " other items of types that this version does not know.\n";
    if (const auto failure = assign(*scene, input.assignments))
        return {std::nullopt, fail(WrongUsage, failure->message)};
    return {std::move(*scene), Done};
}

void tellWarnings(const Scene& scene, const std::string& file)
{
    for (const Finding& problem : problemsOf(scene))
        if (problem.severity == Severity::Warning)
            warn(file + ": " + problem.message.english());
}

void tellIdle(const Scene& scene, const std::string& file, const std::vector<std::string>& paths)
{
    for (const std::string& path : idleAmong(scene, paths))
        warn(file + ": " + path + " changes nothing of this design.");
}

} // namespace ripstop
