// What every kite of the builders flies on: a line from its tow point to a hand, in a wind.
//
// A kite is built nose to +x, y up, and then turned into the wind, which blows towards +x over a
// hand above the origin: at the angle of attack at which air and weight do not turn it about the
// tow point, on a straight line at the wanted angle.
#pragma once

#include "builders/builder.h"
#include "builders/network.h"

#include <array>

namespace ripstop {

// clang-format off
inline constexpr auto flightParameters = std::to_array<Parameter>({
    {"line",         "",      14,     2, 200,   true,  "Segments of the line.", "Line"},
    {"line_length",  "m",     25,     1, 1000,  false, "From the tow point to the hand."},
    {"line_density", "kg/m",  0.0005, 1e-5, 0.1, false, "Mass of the line per length.", {}, {}, {}, isZero("cord")},
    {"line_diameter", "m",    0.0008, 0, 0.02,  false, "Thickness of the line, which the wind drags.", {}, {}, {}, isZero("cord")},
    {"wind",         "m/s",   6,      0, 30,    false, "Speed of the wind.", "Flight"},
    {"gusts",        "m/s",   0,      0, 50,    false, "Wind at 20 ft whose gusts blow as well; 7.7 is light turbulence, 15.4 moderate."},
    {"launch",       "deg",   35,     5, 85,    false, "Angle of the line above the horizon at the start."},
    {"hand_height",  "m",     1.2,    0, 100,   false, "Height of the hand over the ground."},
});
// clang-format on

struct LineMaterials
{
    Id line;
    Id core; // second neighbours in the line, which must not meet the wind once more
};

void addKiteWind(Scene& scene, const Parameters& p);

// Turns the kite to its trim and moves its tow point to where the line has its launch angle.
void launch(const Scene& scene, Network& network, const Parameters& p, Id tow);

struct FlyingLine
{
    Id firstRod;
    std::vector<Id> hand; // last node and hand, pinned at one place and moved together
};
FlyingLine addFlyingLine(Network& network, const Parameters& p, const LineMaterials& materials,
                         Id tow);

void addHandControls(Scene& scene, const std::vector<Id>& hand);
// Adds the probes of the flight, and plots of what gusts do to it when there are some.
void addKiteProbes(Scene& scene, const Parameters& p, Id kite, Id tow, const FlyingLine& line);

inline constexpr const char* kiteNotes =
    "Down pulls the hand back against the wind, Up gives way, Left and Right walk sideways.";

} // namespace ripstop
