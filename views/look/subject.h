// What of a design is looked at when it comes into the view: its fabric and what that hangs by, and
// not the whole line, at whose end a kite is a dot.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace ripstop {

// Particles beside the panels of a part at which three links or more meet that are seen: the tow
// point of a bridle, the risers of a parachute. Ascending.
std::vector<Id> bridlePoints(const Scene& scene, const Part& part);

// The panels of these parts and their bridles; the parts themselves, and what is no part, where
// there are no panels. Ascending.
std::vector<Id> subjectOf(const Scene& scene, const std::vector<Id>& bodies);

} // namespace ripstop
