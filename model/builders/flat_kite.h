// A kite that is a sail on a frame: bridle, tail, mass and flight of those that have no keel.
//
// The builder of a kite lays the sail and has the parameter `bridle`; the rest is the same for all.
// Two rigidity particles are tied to the frame, as in the papers' delta. The bridle's legs go from
// the sail to the tow point, which lies `bridle` times the height below it. The tail is a line
// whose thickness is that of its ribbons, so that the wind draws at it.
//
// With the linear law the centre of pressure is the centroid of the sail at every angle. The tow
// point a little ahead of it turns the nose down, skin friction above it and the tail turn it up:
// the balance is stable, as the first grows with the angle of attack.
#pragma once

#include "builders/kite_flight.h"

#include <functional>

namespace ripstop {

// clang-format off
inline constexpr auto flatKiteParameters = std::to_array<Parameter>({
    {"tail_length",  "m",     3,      0, 50,    false, "Of the tail; 0 leaves it out.", "Tail"},
    {"tail_segments", "",     8,      1, 100,   true,  "Segments of the tail.", {}, {}, {}, isNotZero("tail_length")},
    {"tail_width",   "m",     0.01,   0, 0.2,   false, "Mean width of the tail and its ribbons, which the wind drags."},
    {"tail_density", "kg/m",  0.002,  1e-5, 0.5, false, "Mass of the tail per length.", {}, {}, {}, isNotZero("tail_length")},
    {"fabric",       "kg/m^2", 0.045, 0.005, 1, false, "Mass of the fabric per area; 0.045 is ripstop nylon for kites.", "Mass", {}, {}, isZero("cloth")},
    {"frame_mass",   "kg",    0.06,   0.001, 10, false, "Spars, and the ring at the tow point.", {}, {}, {}, isZero("spars")},
    {"lift_slope",   "1/rad", 2.5,    0.1, 8,   false, "Normal force coefficient per sine of the angle of attack; 2.5 for a plate as wide as it is high.", "Air"},
    {"drag",         "",      0.06,   0, 0.5,   false, "Drag coefficient of sail and spars edge on, as skin friction of the sail."},
});
// clang-format on

struct FlatMaterials
{
    Id sail;
    Id trim; // panels of another colour
    Id seams;
    Id spar;
    Id edge;
};

// What the builder of a kite has laid, nose to +x, y up, z to the right.
struct FlatSail
{
    std::vector<Id> frame; // nodes of the spars, each once
    std::vector<Id> legs;  // where the bridle is tied
    std::vector<Id> tips;  // nose, tail and tips, or corners
    Id tail;               // where the tail is tied
    double height = 0.0;   // m, from the foremost to the rearmost node
    double tow = 0.0;      // 1, where the tow point lies, from 0 at the front to 1
};

struct FlatKite
{
    const char* builder;
    const char* title;
    std::function<FlatSail(Network&, const FlatMaterials&)> sail;
};

Result<Scene> flownFlatKite(const Parameters& p, const FlatKite& kite);

} // namespace ripstop
