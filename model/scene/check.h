// Problems of a scene: what keeps it from running, and what will run but hardly as meant.
#pragma once

#include "scene/finding.h"

namespace ripstop {

// Errors first. At most `most` problems of each sort, so that a broken table of a million rows
// stays readable.
std::vector<Finding> problemsOf(const Scene& scene, std::size_t most = 20);

class ElementIndex;

// The first error, without looking for warnings. `index` is that of the scene as it is.
std::optional<Finding> firstError(const Scene& scene, const ElementIndex& index);
std::optional<Finding> firstErrorOfItems(const Scene& scene, const ElementIndex& index);

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

bool hasErrors(const std::vector<Finding>& problems);

} // namespace ripstop
