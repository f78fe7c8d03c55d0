// Gusts after Dryden: what they are like (GustSpec, part of a System) and what they remember
// (GustState, part of a State). forces/gusts.h has the model and its sources, makes the numbers and
// draws the gusts once in each time step. A DiscreteGust remembers nothing: it follows from the
// time (forces/discrete_gust.h).
#pragma once

#include "base/vec3.h"
#include "system/key.h"

#include <array>

namespace ripstop {

struct GustSpec
{
    Key key = 0;
    Vec3 along = Vec3::UnitX();  // unit, level, with the mean wind
    Vec3 across = Vec3::UnitZ(); // unit, level
    double speed = 1.0;          // m/s, of the mean wind
    double lengthAlong = 1.0;    // m, across as well
    double lengthUp = 1.0;       // m
    double sigmaAlong = 0.0;     // m/s, across as well
    double sigmaUp = 0.0;        // m/s
    int seed = 1;

    friend bool operator==(const GustSpec&, const GustSpec&) = default;
};

// The memory of gusts, in standard deviations, so that it goes on when the gusts become stronger.
struct GustState
{
    double along = 0.0;
    std::array<double, 2> across{};
    std::array<double, 2> up{};

    friend bool operator==(const GustState&, const GustState&) = default;
};

struct DiscreteGust
{
    Vec3 velocity = Vec3::Zero(); // m/s, at the peak of the first
    double onset = 0.0;           // s
    double duration = 1.0;        // s
    double interval = 0.0;        // s, from one to the next; 0 has one only
    double growth = 0.0;          // 1, of the first, that each is stronger than the one before

    friend bool operator==(const DiscreteGust&, const DiscreteGust&) = default;
};

} // namespace ripstop
