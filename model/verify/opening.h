// How parachutes of the builder that hold air (forces/canopy_air.h) open and what they are when
// full.
#pragma once

#include "builders/builder.h"
#include "simulation/simulation.h"

#include <limits>
#include <memory>

namespace ripstop {

inline constexpr double noResult = std::numeric_limits<double>::quiet_NaN();

struct Flight
{
    double width = noResult;  // of the canopy over the nominal diameter
    double height = noResult; // of the canopy over the nominal diameter, from widest place to crown
    double drag = noResult;   // 1, CD0 at the end
    double filled = noResult; // n, nominal diameters that go by until the drag area is full
    double growth = noResult; // j of (CD S)(t) = CD S (t / tf)^j
    double highest = noResult; // N, pull on the payload, mean over 1/40 s
    double volume = noResult;  // over the cube of the nominal diameter
};

struct Chute
{
    Parameters parameters;
    double speed = 0.0;     // m/s
    bool held = false;      // whether the payload is pinned in wind of that speed, or falls
    double until = 1.0;     // s
    double gravity = 0.0;   // m/s^2
    double viscosity = 0.0; // 1/s
};

// The parachute at the start of its flight.
std::unique_ptr<Simulation> made(const Chute& chute);

// Flies it until `until`. All results are noResult when the simulation stops before that.
Flight fly(const Chute& chute);

// The size of the C-9 parachute: D0 8.53 m, 28 gores, lines of 7.3 m, 100 kg; a mouth of 5 % of D0
// at the start.
Parameters sizeOfC9();

// What a C-9 is made of: nylon of 1.1 oz on cords of 550 lb.
Parameters nylonOfC9();

// One set of parameters and, for those that it does not have, another.
Parameters joined(Parameters one, const Parameters& other);

// The C-9 with its payload held in wind of that speed, m/s, until twelve diameters have gone by.
// Held in 60 m/s one of nylon has loads of 40 kN and more, which break its lines.
Chute heldC9(double speed, const Parameters& materials = {});

} // namespace ripstop
