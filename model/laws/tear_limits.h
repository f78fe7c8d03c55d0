// At what links and panels tear, as the engine judges it (tearing/tearing.h) and colours show it.
// The scene says it by materials (derived/tear_bounds.h), in rules of which some hold for both.
#pragma once

#include "laws/link_laws.h"

#include <limits>

namespace ripstop {

// When a link tears; the rule says what the limit is of. It is Never, Length, Strain or Force: a
// pull per width is a force on a thread whose width is known.
struct TearLimit
{
    TearRule rule = TearRule::Never;
    double limit = 0.0; // m of length, 1 of strain or N of force

    friend bool operator==(const TearLimit&, const TearLimit&) = default;
};

// The limit of what is so many times as strong. A length is no strength of what has it.
constexpr TearLimit timesStrength(TearLimit tear, double factor)
{
    if (tear.rule != TearRule::Length)
        tear.limit *= factor;
    return tear;
}

// When a panel that carries the pull of a fabric tears: above either limit, or where a tear ends
// that is driven on by more than the energy (tearing/tear_tips.h). The rule is Never, Tension or
// Strain.
struct FabricTear
{
    static constexpr double unbreakable = std::numeric_limits<double>::infinity();

    TearRule rule = TearRule::Never;
    double warp = unbreakable; // N/m or 1, of the warp threads
    double weft = unbreakable;
    double energy = 0.0; // J/m, of a tear that goes on; 0 where that is not looked at

    friend bool operator==(const FabricTear&, const FabricTear&) = default;
};

constexpr FabricTear timesStrength(FabricTear tear, double factor)
{
    tear.warp *= factor;
    tear.weft *= factor;
    tear.energy *= factor;
    return tear;
}

} // namespace ripstop
