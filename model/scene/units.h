// Units that people type instead of those of the table of properties.
//
// Only simple units are listed; km/h, N s/m or g/m² are made of them as they are written.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// Powers of metre, kilogram, second and radian. An angle counts as one, so that a number of degrees
// is not mistaken for a factor.
using Dimension = std::array<int, 4>;

struct Unit
{
    std::string_view name;
    double factor; // SI units in one of these
    Dimension dimension;
};

// Null when there is none of this name.
const Unit* findUnit(std::string_view name);

// What a number in `unit` is to be multiplied by to be in `wanted`: 0.001 from "g" to "kg", 0.01
// from "%" to "". Nothing where the two do not measure the same. Squares may be written m², m^2 or
// m2; an empty unit is the wanted one.
std::optional<double> unitFactor(std::string_view unit, std::string_view wanted);

// The units that can be typed where `wanted` is wanted, that one first. There may be more: any
// product of units of that dimension will do.
std::vector<std::string> unitsLike(std::string_view wanted);

} // namespace ripstop
