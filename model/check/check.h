// Problems of a scene: errors, which keep it from running, and warnings, which let it run but
// hardly as its author means it.
// Compiling asks for the first error; the update of a running system asks only about what was
// touched; the follower thread of the editor and the command line ask for the whole list. All
// functions read the scene and write nothing. Files of colliders are read through the cache of
// shapes/shape_files.h.
#pragma once

#include "check/finding.h"
#include "check/step_limits.h"

namespace ripstop {

// All problems, errors first. The list has at most `most` problems of each sort, so that a broken
// table of a million rows stays readable.
std::vector<Finding> problemsOf(const Scene& scene, std::size_t most = 20);

class ElementIndex;

// The first error, without looking for warnings of the mesh and the run; the second function looks
// at items only. `index` is that of the scene as it is.
std::optional<Finding> firstError(const Scene& scene, const ElementIndex& index);
std::optional<Finding> firstErrorOfItems(const Scene& scene, const ElementIndex& index);

// Whether an element has no error of its own: what is left to check when only its values changed.
bool isSound(const ConstRef& element, const ElementIndex& index);

// The longest substep at which springs and bending of a scene are sure to be stable, and the
// particle that asks for it (laws/step_limit.h). Nothing when there are neither.
struct StepLimit
{
    double timeStep; // s
    Id particle;
    StepLimitCause cause; // with bending, Solver::Auto keeps to the limit
};
std::optional<StepLimit> stepLimit(const Scene& scene);

// Whether the substep of the settings is above the limit. Solver::Auto shortens its own substeps
// where something bends, so that it does not exceed such a limit.
bool exceeds(const Settings& settings, const StepLimit& limit);

// How many substeps keep to the limit with a fifth to spare; not more than a scene may have.
int substepsWithin(const StepLimit& limit, const Settings& settings);

bool hasErrors(const std::vector<Finding>& problems);

} // namespace ripstop
