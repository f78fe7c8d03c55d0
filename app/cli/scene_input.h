// The scene of a command, with what --set changes in it. The commands that take a scene share its
// options and its messages: a file that cannot be read ends in BadInput, an assignment that does
// not fit in WrongUsage.
#pragma once

#include "base/result.h"
#include "cli/commands.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// What the user has given.
struct SceneInput
{
    std::string file;
    std::vector<std::string> assignments; // "PATH=VALUE"
};

void addSceneOption(CLI::App& command, SceneInput& input);

// Accepts a finite number in the range. CLI::Range is not used because it lets "nan" through.
CLI::Validator numberBetween(double low, double high);

// The same of a number in a unit, for ->transform(): "24 in", "60 cm" and "2/3 ft" are as good as a
// bare one, which is in `unit`, a literal; and of a time.
CLI::Validator quantityBetween(double low, double high, std::string_view unit);
CLI::Validator secondsBetween(double low, double high);

// --threads, all of the machine's when it is left out.
void addThreadsOption(CLI::App& command, int& threads);

void addSetOption(CLI::App& command, std::vector<std::string>& assignments);

// The scene; or none and the exit code, after a message has been printed.
struct SceneOutcome
{
    std::optional<Scene> scene;
    int exitCode = 0;
};
SceneOutcome loadScene(const SceneInput& input);

// Says on the standard error what will not do what it seems to, as the list of problems in the
// window does; before something is flown. Errors are told by whoever cannot go on.
void tellWarnings(const Scene& scene, const std::string& file);

// Of what a sweep or a study sets, that which changes nothing of this design.
void tellIdle(const Scene& scene, const std::string& file, const std::vector<std::string>& paths);

// Sets what a sweep can set, parameters of builders first (study/point_scene.h); a failure names
// the first that does not fit.
std::optional<Failure> assign(Scene& scene, const std::vector<std::string>& assignments);

// Saves what a command has made. What --set has made of it may be something that no file can say,
// like a group of things that are not there; that is refused, and the file stays as it was.
std::optional<Failure> saveReadable(const Scene& scene, const std::string& file);

} // namespace ripstop
