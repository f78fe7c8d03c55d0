#include "scene/units.h"

#include "base/angle.h"
#include "scene/expression.h"

#include <algorithm>
#include <numbers>

namespace ripstop {
namespace {

constexpr Dimension one{}, length{1}, mass{0, 1}, time{0, 0, 1}, force{1, 1, -2}, speed{1, 0, -1},
    pressure{-1, 1, -2}, energy{2, 1, -2}, power{2, 1, -3}, angle{0, 0, 0, 1}, rate{0, 0, -1},
    volume{3};

// Pound, ounce, inch, mile and knot are exact by definition.
constexpr double pound = 0.45359237; // kg
constexpr double gravity = 9.80665;  // m/s^2, of kgf and lbf
constexpr double yard = 0.9144;      // m

// clang-format off
constexpr std::array units{
    Unit{"m", 1.0, length},         Unit{"mm", 1e-3, length},   Unit{"cm", 1e-2, length},
    Unit{"dm", 0.1, length},        Unit{"km", 1e3, length},    Unit{"um", 1e-6, length},
    Unit{"\u00b5m", 1e-6, length},
    Unit{"in", 0.0254, length},     Unit{"ft", 0.3048, length}, Unit{"yd", yard, length},
    Unit{"mi", 1609.344, length},
    Unit{"kg", 1.0, mass},          Unit{"mg", 1e-6, mass},     Unit{"g", 1e-3, mass},
    Unit{"t", 1e3, mass},           Unit{"oz", pound / 16, mass}, Unit{"lb", pound, mass},
    Unit{"s", 1.0, time},           Unit{"ms", 1e-3, time},     Unit{"us", 1e-6, time},
    Unit{"\u00b5s", 1e-6, time},
    Unit{"min", 60.0, time},        Unit{"h", 3600.0, time},
    Unit{"N", 1.0, force},          Unit{"mN", 1e-3, force},    Unit{"cN", 1e-2, force},
    Unit{"daN", 10.0, force},       Unit{"kN", 1e3, force},     Unit{"MN", 1e6, force},
    Unit{"kgf", gravity, force},    Unit{"lbf", pound * gravity, force},
    Unit{"kn", 1852.0 / 3600, speed}, Unit{"kt", 1852.0 / 3600, speed}, Unit{"mph", 1609.344 / 3600, speed}, Unit{"kph", 1 / 3.6, speed},
    Unit{"Pa", 1.0, pressure},      Unit{"hPa", 1e2, pressure}, Unit{"kPa", 1e3, pressure},
    Unit{"MPa", 1e6, pressure},     Unit{"GPa", 1e9, pressure}, Unit{"bar", 1e5, pressure},
    Unit{"mbar", 1e2, pressure},
    Unit{"J", 1.0, energy},         Unit{"mJ", 1e-3, energy},   Unit{"\u00b5J", 1e-6, energy},
    Unit{"uJ", 1e-6, energy},       Unit{"kJ", 1e3, energy},    Unit{"W", 1.0, power},
    Unit{"l", 1e-3, volume},        Unit{"Hz", 1.0, rate},
    Unit{"rad", 1.0, angle},        Unit{"deg", degrees, angle}, Unit{"degrees", degrees, angle},
    Unit{"degree", degrees, angle}, Unit{"\u00b0", degrees, angle},
    Unit{"%", 0.01, one},           Unit{"\u2030", 0.001, one},
};

// What messages and lists offer, besides the simple units.
constexpr std::array<std::string_view, 31> composed{
    "N/mm", "N/cm", "kN/m", "N/m", "N s/m", "mm/N", "mm/kN", "m/N", "mm/s", "cm/s", "km/h", "m/s",
    "m/s\u00b2", "mm\u00b2", "cm\u00b2", "dm\u00b2", "ft\u00b2", "m\u00b2", "g/m\u00b2",
    "oz/yd\u00b2", "kg/m\u00b2", "g/m", "kg/m", "g/l", "kg/m\u00b3", "N mm", "N m", "N mm\u00b2",
    "N m\u00b2", "1/min", "1/s"};
// clang-format on

} // namespace

const Unit* findUnit(std::string_view name)
{
    const auto found =
        std::ranges::find_if(units, [&](const Unit& unit) { return unit.name == name; });
    return found == units.end() ? nullptr : &*found;
}

std::optional<double> unitFactor(std::string_view unit, std::string_view wanted)
{
    if (unit.empty() || unit == wanted)
        return 1.0;
    const std::optional<Measured> from = measureOfUnit(unit), to = measureOfUnit(wanted);
    if (!from || !to || from->dimension != to->dimension)
        return std::nullopt;
    return from->value / to->value;
}

std::vector<std::string> unitsLike(std::string_view wanted)
{
    const std::optional<Measured> to = measureOfUnit(wanted);
    std::vector<std::string> names;
    if (!wanted.empty())
        names.emplace_back(wanted);
    if (!to)
        return names;
    const auto offer = [&](std::string_view name, const Dimension& dimension) {
        if (dimension == to->dimension && name != wanted)
            names.emplace_back(name);
    };
    for (const Unit& unit : units)
        offer(unit.name, unit.dimension);
    for (const std::string_view name : composed)
        if (const auto made = measureOfUnit(name))
            offer(name, made->dimension);
    return names;
}

} // namespace ripstop
