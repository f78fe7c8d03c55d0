// Keys are the ids of the scene's elements, opaque to the engine: they tell which particle of an
// edited system is which. Twins that tears make have keys above those of any scene
// (assembly/split_system.h).
#pragma once

#include <cstdint>

namespace ripstop {

using Key = std::uint32_t;

} // namespace ripstop
