// How parachutes of the builder that hold air (forces/canopy_air.h) open and what they are when
// full.
#pragma once

#include "builders/builder.h"
#include "run/simulation.h"

#include <limits>
#include <memory>

namespace ripstop {

inline constexpr double noResult = std::numeric_limits<double>::quiet_NaN();

struct Flight
{
    double width = noResult;   // of the canopy over the nominal diameter
    double height = noResult;  // of the same, from the widest place to the crown
    double drag = noResult;    // 1, CD0 at the end
    double filled = noResult;  // n, nominal diameters that go by until the drag area is full
    double growth = noResult;  // j of (CD S)(t) = CD S (t / tf)^j
    double highest = noResult; // N, pull on the payload, mean over 1/40 s
    double volume = noResult;  // over the cube of the nominal diameter
};

struct Chute
{
    Parameters parameters;
    double speed = 0.0;     // m/s
    bool held = false;      // the payload is, in wind of that speed; otherwise it flies
    double until = 1.0;     // s
    double gravity = 0.0;   // m/s^2
    double viscosity = 0.0; // 1/s
};

// At the start of its flight.
std::unique_ptr<Simulation> made(const Chute& chute);

// No results when it cannot be flown so far.
Flight fly(const Chute& chute);

// D0 8.53 m, 28 gores, lines of 7.3 m, 100 kg; a mouth of 5 % of D0 at the start.
Parameters sizeOfC9();

// The same in wind of that speed, m/s, with its payload held, for twelve diameters to go by.
Chute heldC9(double speed);

} // namespace ripstop
