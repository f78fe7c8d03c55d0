// Lines things up: on one side of what is selected, at even distances, or in one plane.
//
// Where two or more items are selected (parts, groups, colliders), each moves as a whole and is
// taken by the box around it; otherwise each particle moves by itself.
#pragma once

#include "shaping/transform.h"

namespace ripstop {

enum class Side { Least, Middle, Most };

// Moves along one axis only. Side::Middle is the middle of the box around everything.
Edit aligned(const Scene& scene, const std::vector<Id>& ids, int axis, Side side,
             RestLengths restLengths);

// The outermost ones stay, those between come to stand at even steps, in the order in which they
// are. Fewer than three are left as they are.
Edit distributed(const Scene& scene, const std::vector<Id>& ids, int axis, RestLengths restLengths);

// Puts particles into the plane that fits them best: through their mean, across the direction in
// which they spread least.
Edit flattened(const Scene& scene, const std::vector<Id>& ids, RestLengths restLengths);

} // namespace ripstop
