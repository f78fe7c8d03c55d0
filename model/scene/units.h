// Units that people type instead of those of the table of properties.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// What a number in `unit` is to be multiplied by to be in `wanted`: 0.001 from "g" to "kg", 0.01
// from "%" to "". Nothing where the two do not measure the same. Squares may be written m², m^2 or
// m2; an empty unit is the wanted one.
std::optional<double> unitFactor(std::string_view unit, std::string_view wanted);

// The units that can be typed where `wanted` is wanted, that one first.
std::vector<std::string> unitsLike(std::string_view wanted);

} // namespace ripstop
