// The longest substep that springs and bending allow at each particle of a scene that is not
// compiled, s; the formula and its source stand in laws/step_limit.h. The check of a scene takes
// the smallest one, and the stability look of the author (author/stability.h) reads all of them.
// Nothing in it fails: references to nothing are passed over.
//
// Springs that are solved together with rods bound nothing. They are as soon as one of them is too
// stiff for a substep that the settings allow, where solver and integrator may do so; all of them,
// so that what hangs on a chain of springs is solved at once. Springs without stiffness, which only
// damp, stay forces.
#pragma once

#include "base/message.h"
#include "scene/element_index.h"
#include "scene/scene.h"

namespace ripstop {

// What a limit comes from.
struct StepLimitCause
{
    bool springs = false; // some spring pulls or damps as a force
    bool bending = false; // something resists bending, as a force

    // "springs", "bending", or "springs and bending"; empty when nothing asks.
    Message said() const;
};

struct StepLimits
{
    std::vector<double> timeStep; // s, [particles] through all parts; infinity where nothing asks
    StepLimitCause cause;
    bool springsTogether = false; // with rods
};
StepLimits stepLimitsOf(const Scene& scene, const ElementIndex& index);

// The last of these alone: some spring has a stiffness, and all that have one join the rods.
bool springsAreTogether(const Scene& scene, const ElementIndex& index);

// N/m and N s/m, of a spring with its own numbers or those of its material.
struct SpringNumbers
{
    double stiffness;
    double damping;
};
SpringNumbers springNumbers(const Link& link, const Material& material);

} // namespace ripstop
