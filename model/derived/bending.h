// What bending (laws/bend.h) asks of the step in a scene that is not compiled: for each particle
// the sum of the stiffnesses of the bends that it takes part in.
// The step limit of a scene (step_limits.cpp) adds these sums to those of the springs. It is a
// function of its arguments alone and reports no errors.
#pragma once

#include "laws/bend.h"
#include "scene/element_index.h"
#include "scene/scene.h"

#include <functional>

namespace ripstop {

// [particles] N/m, counted through all parts in the author's order; empty when no material resists
// bending. Links and panels that point at no particle are passed over. Spars of rods ask for
// nothing where these are solved together, nor does fabric that is solved with what carries its
// pull (laws/fabric_bending.h).
//   index  of the scene as it is
//   isRod  of a link, as the system has it
std::vector<double> bendSumsOf(const Scene& scene, const ElementIndex& index,
                               const std::function<bool(const Link&)>& isRod);

} // namespace ripstop
