// The scene of a command, with what --set changes in it.
#pragma once

#include "base/result.h"
#include "cli/commands.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace ripstop {

struct SceneInput
{
    std::string file;
    std::vector<std::string> assignments; // "PATH=VALUE"
};

void addSceneOption(CLI::App& command, SceneInput& input);

// A finite number in a range; CLI::Range lets "nan" through.
CLI::Validator numberBetween(double low, double high);

void addSetOption(CLI::App& command, std::vector<std::string>& assignments);

// The scene, or the exit code after a message.
struct SceneOutcome
{
    std::optional<Scene> scene;
    int exitCode = 0;
};
SceneOutcome loadScene(const SceneInput& input);

// Applies the assignments in their order; a failure names the first that does not fit.
std::optional<Failure> assign(Scene& scene, const std::vector<std::string>& assignments);

} // namespace ripstop
