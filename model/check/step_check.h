// What springs and bending ask of the step of a scene: the longest substep at which they are sure
// to be stable, and what to say where the settings do not keep to it, or where a few narrow cells
// make all fabric pay for theirs. A part of check.h.
#pragma once

#include "check/elastic_check.h"
#include "check/step_limits.h"

#include <optional>

namespace ripstop {

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

void checkStep(const Scene& scene, const ElementIndex& index, const AddFinding& add);

} // namespace ripstop
