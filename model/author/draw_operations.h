// The operations that draw: links, ropes, spars, panels, rigidity particles.
#pragma once

#include "author/operation.h"

namespace ripstop {

std::span<const Operation> drawOperations();

} // namespace ripstop
