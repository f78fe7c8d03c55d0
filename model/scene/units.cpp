#include "scene/units.h"

#include <array>
#include <numbers>

namespace ripstop {
namespace {

struct Unit
{
    std::string_view name;
    std::string_view base; // units of one base measure the same
    double factor;         // base units in one of these
};

// Pound, ounce, inch, mile and knot are exact by definition.
constexpr double pound = 0.45359237;                // kg
constexpr double gravity = 9.80665;                 // m/s^2, of kgf and lbf
constexpr double yard = 0.9144;                     // m
constexpr double degree = std::numbers::pi / 180.0; // rad

// clang-format off
constexpr std::array units{
    Unit{"m", "m", 1.0},         Unit{"mm", "m", 1e-3},        Unit{"cm", "m", 1e-2},
    Unit{"dm", "m", 0.1},        Unit{"km", "m", 1e3},         Unit{"in", "m", 0.0254},
    Unit{"ft", "m", 0.3048},     Unit{"yd", "m", yard},
    Unit{"kg", "kg", 1.0},       Unit{"mg", "kg", 1e-6},       Unit{"g", "kg", 1e-3},
    Unit{"t", "kg", 1e3},        Unit{"oz", "kg", pound / 16}, Unit{"lb", "kg", pound},
    Unit{"s", "s", 1.0},         Unit{"ms", "s", 1e-3},        Unit{"min", "s", 60.0},
    Unit{"N", "N", 1.0},         Unit{"mN", "N", 1e-3},        Unit{"cN", "N", 1e-2},
    Unit{"daN", "N", 10.0},      Unit{"kN", "N", 1e3},         Unit{"kgf", "N", gravity},
    Unit{"lbf", "N", pound * gravity},
    Unit{"N/m", "N/m", 1.0},     Unit{"N/mm", "N/m", 1e3},     Unit{"N/cm", "N/m", 1e2},
    Unit{"kN/m", "N/m", 1e3},
    Unit{"N s/m", "N s/m", 1.0},
    Unit{"m/N", "m/N", 1.0},     Unit{"mm/N", "m/N", 1e-3},    Unit{"mm/kN", "m/N", 1e-6},
    Unit{"m/s", "m/s", 1.0},     Unit{"mm/s", "m/s", 1e-3},    Unit{"cm/s", "m/s", 1e-2},
    Unit{"km/h", "m/s", 1 / 3.6}, Unit{"kn", "m/s", 1852.0 / 3600}, Unit{"mph", "m/s", 1609.344 / 3600},
    Unit{"m/s2", "m/s2", 1.0},
    Unit{"m2", "m2", 1.0},       Unit{"mm2", "m2", 1e-6},      Unit{"cm2", "m2", 1e-4},
    Unit{"dm2", "m2", 1e-2},     Unit{"ft2", "m2", 0.3048 * 0.3048},
    Unit{"kg/m2", "kg/m2", 1.0}, Unit{"g/m2", "kg/m2", 1e-3},  Unit{"oz/yd2", "kg/m2", pound / 16 / (yard * yard)},
    Unit{"kg/m", "kg/m", 1.0},   Unit{"g/m", "kg/m", 1e-3},
    Unit{"kg/m3", "kg/m3", 1.0},
    Unit{"Pa", "Pa", 1.0},       Unit{"N/m2", "Pa", 1.0},      Unit{"hPa", "Pa", 1e2},
    Unit{"kPa", "Pa", 1e3},
    Unit{"N m", "N m", 1.0},     Unit{"N mm", "N m", 1e-3},
    Unit{"N m2", "N m2", 1.0},
    Unit{"degrees", "rad", degree}, Unit{"deg", "rad", degree}, Unit{"°", "rad", degree},
    Unit{"rad", "rad", 1.0},
    Unit{"1/s", "1/s", 1.0},
    Unit{"", "", 1.0},           Unit{"%", "", 0.01},
};
// clang-format on

// "m²" and "m^2" as "m2", "N·m" as "N m".
std::string plain(std::string_view unit)
{
    std::string text(unit);
    const auto replace = [&text](std::string_view from, std::string_view to) {
        for (auto at = text.find(from); at != std::string::npos;
             at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    };
    replace("\u00b2", "2");
    replace("\u00b3", "3");
    replace("^", "");
    replace("\u00b7", " ");
    replace("\u00b5", "u");
    return text;
}

const Unit* findUnit(std::string_view name)
{
    for (const Unit& unit : units)
        if (unit.name == name)
            return &unit;
    return nullptr;
}

} // namespace

std::optional<double> unitFactor(std::string_view unit, std::string_view wanted)
{
    const std::string typed = plain(unit), target = plain(wanted);
    if (typed.empty() || typed == target)
        return 1.0;
    const Unit* from = findUnit(typed);
    const Unit* to = findUnit(target);
    if (!from || !to || from->base != to->base)
        return std::nullopt;
    return from->factor / to->factor;
}

std::vector<std::string> unitsLike(std::string_view wanted)
{
    const Unit* to = findUnit(plain(wanted));
    std::vector<std::string> names;
    if (!wanted.empty())
        names.emplace_back(wanted);
    for (const Unit& unit : units)
        if (to && unit.base == to->base && unit.name != to->name && !unit.name.empty())
            names.emplace_back(unit.name);
    return names;
}

} // namespace ripstop
