// Wings cut into strips along the wind, for the vortex law (vortex_wing.h).
//
// A wing is a piece of fabric: triangles that hang together by their corners. It is laid flat, x
// along the chord from front to rear, y along the span, and cut into strips from tip to tip. With
// y = -b/2 cos t the cuts are at equal steps of t, so that strips are narrow at the tips, and
// halfway between them in t the flow is checked. The chord runs with the wind that the wing meets
// at the start; without one it runs across the longest way, with the narrow end in front.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

inline constexpr int wingStrips = 16;
inline constexpr int wingStations = 2 * wingStrips + 1; // cuts are the even ones, checks the odd

// cos(pi m / 32) of a station: from 1 to -1, exactly antisymmetric.
const std::array<double, wingStations>& stationCosines();

// A place on the rim: a + share (b - a) of two particles.
struct RimPoint
{
    int a;
    int b;
    double share;

    friend bool operator==(const RimPoint&, const RimPoint&) = default;
};

// How much a strip and a panel have to do with each other.
struct StripPart
{
    int strip;
    int panel;   // index into WingStrips::panels
    double area; // 1, share of the panel that lies in the strip
    double wash; // 1, weight of the panel's wind in that of the strip; of a strip they sum to 1
    double load; // 1, what the panel carries of the strip's force; of a strip they sum to 1

    friend bool operator==(const StripPart&, const StripPart&) = default;
};

struct WingStrips
{
    std::vector<int> panels;                  // indices, ascending
    std::vector<double> side;                 // [panels] -1 where the corners run the other way
    std::array<RimPoint, wingStations> front; // leading edge at the stations
    std::array<RimPoint, wingStations> rear;  // trailing edge
    std::vector<StripPart> parts;             // by strip, then by panel

    friend bool operator==(const WingStrips&, const WingStrips&) = default;
};

// The wings among `corners`, in the order of their first panels. Pieces that have no area, or
// cannot be cut into strips, are left out.
//   corners   [panels]     particle indices
//   member    [panels]     whether the panel takes part
//   position  [particles]  m, at the start
//   wind      [panels]     m/s, that the panel meets at the start
std::vector<WingStrips> wingsOf(std::span<const std::array<int, 3>> corners,
                                std::span<const std::uint8_t> member,
                                std::span<const PaddedVec3> position, std::span<const Vec3> wind);

using WingRim = std::array<Vec3, wingStations>; // m

// The places of the points of a rim, m.
//   position  [particles]  m
WingRim rimOf(const std::array<RimPoint, wingStations>& places,
              std::span<const PaddedVec3> position);

} // namespace ripstop
