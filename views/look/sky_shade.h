// How much of the light from all around the fabric keeps from itself: it is darker inside a canopy,
// between two sails, in the bottom of a fold (ambient occlusion).
//
// The fabric is looked at from so many directions, spread evenly (a spiral, Gonzalez 2010), with
// the shade that it throws for each (self_shade.h); what comes at a slant counts by its cosine.
// Cloth has two sides, which see two halves of the world. On a slow core that takes 3 ms for a kite
// and 27 ms for 20 000 panels.
#pragma once

#include "look/self_shade.h"

namespace ripstop {

class SkyShade
{
public:
    static constexpr int directions = 16;

    // As SelfShade has it.
    //     shade  [particles]  out, of the side of the normal and of the other: 0 where all is open,
    //                         1 where fabric is all that is seen
    void cast(std::span<const Vec3> places, std::span<const std::array<float, 3>> normals,
              std::span<const Corners> panels, std::span<const std::uint8_t> present,
              std::span<std::array<float, 2>> shade);

private:
    SelfShade m_self{128};                     // what comes from all around has no edges
    std::vector<float> m_shade;                // [particles] from one direction
    std::vector<std::array<float, 2>> m_light; // [particles] 1, the cosines so far of either side
};

} // namespace ripstop
