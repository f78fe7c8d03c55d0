// The operations that draw: links, ropes, spars, panels, rigidity particles. operation.cpp appends
// these rows to its own; everybody else asks operation.h.
#pragma once

#include "shaping/operation.h"

namespace ripstop {

std::span<const Operation> drawOperations();

} // namespace ripstop
