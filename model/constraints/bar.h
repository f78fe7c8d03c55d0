// A rod as the direct solver has it (direct_solver.h): what an iteration measures of it, and what
// it is of the sums that the solver looks at. All of it is of one rod, and made to be inlined into
// the passes over all of them.
#pragma once

#include "base/vec3.h"
#include "laws/link_laws.h"
#include "parallel/simd_pack.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ripstop {

RIPSTOP_INLINE double dot(const Row& a, const Row& b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

constexpr double atRest = 1e-12; // of the length: lines that are neither slack nor tight take part

struct Bar
{
    Row direction{};     // unit, from `a` to `b`
    std::uint32_t a = 0; // row of the solver's positions; pins come last
    std::uint32_t b = 0;
    int rod = 0;         // in System::rods
    int pair = -1;       // in the matrix; -1 when an end is pinned
    bool guided = false; // an end is on a guide
    Resists resists = Resists::Both;
    bool torn = false;
    bool isElastic = false;  // has a compliance
    bool active = false;     // takes part in this iteration
    double weight = 0.0;     // 1/kg, of both ends
    double softness = 0.0;   // 1/kg, its compliance over h^2
    double rest = 0.0;       // m
    double length = 0.0;     // m
    double stretch = 0.0;    // m
    double multiplier = 0.0; // kg m, that the linear system gave
    double before = 0.0;     // kg m, of the iteration before
    double atStart = 0.0;    // kg m, of the substep before
    double foreseen = 0.0;   // kg m, if its ends went on as they came; of one that resists one way
};

RIPSTOP_INLINE void measure(Bar& bar, const Row& a, const Row& b)
{
    const Pack d = pack(b.v) - pack(a.v);
    bar.length = __builtin_sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    pack(bar.direction.v) = d * (bar.length > 0.0 ? 1.0 / bar.length : 0.0);
    bar.stretch = bar.length - bar.rest;
}

// A rod of no length holds its ends together from every side; coincident ends of one that has a
// length show no direction to move along.
RIPSTOP_INLINE bool acts(const Bar& bar)
{
    if (bar.torn || (bar.length == 0.0 && bar.rest > 0.0))
        return false;
    switch (bar.resists) {
    case Resists::Tension:
        return bar.rest == 0.0 || bar.multiplier * bar.weight + bar.stretch > -atRest * bar.rest;
    case Resists::Compression:
        return bar.multiplier * bar.weight + bar.stretch < atRest * bar.rest;
    case Resists::Both:
        break;
    }
    return true;
}

// How much an idle line is too long, or an idle strut too short (negative), m.
RIPSTOP_INLINE double excess(const Bar& bar)
{
    if (bar.torn)
        return 0.0;
    switch (bar.resists) {
    case Resists::Tension:
        return std::max(bar.stretch, 0.0);
    case Resists::Compression:
        return std::min(bar.stretch, 0.0);
    case Resists::Both:
        break;
    }
    return 0.0; // a rod that resists both ways is idle only with coincident ends
}

// kg m
RIPSTOP_INLINE double pullOf(const Bar& bar)
{
    switch (bar.resists) {
    case Resists::Tension:
        return std::max(bar.multiplier, 0.0);
    case Resists::Compression:
        return std::min(bar.multiplier, 0.0);
    case Resists::Both:
        break;
    }
    return bar.multiplier;
}

// Whether the rod met a load that its ends ran into: it pulls more than twice as hard as before,
// and yet less than half of what their way would have made of its stretch, since it has stopped
// them. A load that it takes up as slowly as it swings makes just that of it.
RIPSTOP_INLINE bool stopsItsEnds(const Bar& bar)
{
    const double pull = std::abs(pullOf(bar));
    const double before = std::abs(bar.atStart);
    return bar.resists != Resists::Both && pull > 2.0 * before
           && pull - before < 0.5 * (std::abs(bar.foreseen) - before);
}

// Twice the energy that the pull of the multiplier takes, kg m^2.
RIPSTOP_INLINE double energyOfPull(const Bar& bar)
{
    return bar.softness * bar.multiplier * bar.multiplier;
}

// Twice the energy of what the pull of an elastic rod differs by from that of its length, kg m^2.
RIPSTOP_INLINE double energyOfError(const Bar& bar)
{
    if (!bar.isElastic)
        return 0.0;
    const double off = bar.active ? bar.stretch - bar.softness * bar.multiplier : excess(bar);
    return off * off / bar.softness;
}

// Twice what a rod is of the sum that is minimised, while it is active or not; kg m^2.
RIPSTOP_INLINE double energyOf(const Bar& bar)
{
    const double c = bar.active ? bar.stretch : excess(bar);
    return c * c / bar.softness;
}

// How far a rod is from where the linear system put it, m; a line that pushed counts with what that
// moved its ends.
RIPSTOP_INLINE double missOf(const Bar& bar)
{
    const double off =
        std::abs(bar.active ? bar.stretch - bar.softness * bar.multiplier : excess(bar));
    const bool pushed = (bar.resists == Resists::Tension && bar.multiplier < 0.0)
                        || (bar.resists == Resists::Compression && bar.multiplier > 0.0);
    return pushed ? off + std::abs(bar.multiplier) * bar.weight : off;
}

} // namespace ripstop
