// Along the frontier: the points of a grid that tell where outcomes change, without the rest.
//
// The outcome of a flight is whether the design held. A coarse grid is flown first, every 2^k-th
// value of each variable and the last ones; then, step by step halved, what lies in boxes of it of
// which some points held and others did not. What is found on a side of a box counts for the box
// behind it, so that a border that wanders is followed. A region that is smaller than a box of the
// coarse grid and touches none of its points is not found.
//
// Which points are needed next is a function of those that are known, so that a search that is
// ended goes on where it was, on any number of machines.
#pragma once

#include "study/study.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace ripstop {

// Whether the design held in this point; nothing where that is not known.
using HeldAt = std::function<std::optional<bool>(std::size_t point)>;

// The unknown points that are needed next, ascending; none when the frontier is found.
std::vector<std::size_t> frontierPoints(const Study& study, const HeldAt& heldAt);

} // namespace ripstop
