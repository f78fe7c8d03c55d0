// Problems of a scene: what keeps it from running, and what will run but hardly as meant.
#pragma once

#include "scene/property.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class Severity { Error, Warning };

struct Problem
{
    Severity severity;
    std::string message;        // what is wrong and what to do about it
    Id culprit{};               // item or element; noId when it is the scene as a whole
    std::string_view sort = {}; // "step", "loose": the same for all of its sort
};

// Errors first. At most `most` problems of each sort, so that a broken table of a million rows
// stays readable.
std::vector<Problem> problemsOf(const Scene& scene, std::size_t most = 20);

class ElementIndex;

// The first error, without looking for warnings. `index` is that of the scene as it is.
std::optional<Problem> firstError(const Scene& scene, const ElementIndex& index);
std::optional<Problem> firstErrorOfItems(const Scene& scene, const ElementIndex& index);

// Whether an element has no error of its own: what is left to check when only its values changed.
bool isSound(const ConstRef& element, const ElementIndex& index);

// The longest substep at which springs and bending of a scene are sure to be stable, and the
// particle that asks for it (base/step_limit.h). Nothing when there are neither.
struct StepLimit
{
    double timeStep; // s
    Id particle;
    bool bends = false; // something resists bending, so that Solver::Auto keeps to the limit
};
std::optional<StepLimit> stepLimit(const Scene& scene);
bool exceeds(const Settings& settings, const StepLimit& limit);

bool hasErrors(const std::vector<Problem>& problems);

} // namespace ripstop
