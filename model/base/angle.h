// Degrees, for what people type and read; everything inside is in radians.
#pragma once

#include <numbers>

namespace ripstop {

inline constexpr double degrees = std::numbers::pi / 180.0; // rad

} // namespace ripstop
