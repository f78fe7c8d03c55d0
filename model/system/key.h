// Keys are the ids of the scene's elements, opaque here: they tell which particle of an edited
// system is which.
#pragma once

#include <cstdint>

namespace ripstop {

using Key = std::uint32_t;

} // namespace ripstop
