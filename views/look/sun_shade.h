// How much of the sun's light the fabric keeps from itself: in its folds, inside a canopy, below a
// sail that lies over another.
//
// The fabric is drawn once as the sun sees it, into a picture of how near to the sun it is. A place
// is in the shade by the share of the pixels around its own that something nearer to the sun has.
// What is nearer than the plane of the fabric there by a few pixels' width only is taken for the
// surface that the place lies on; folds as small as that throw no shade. All of it runs
// on the calling thread, in about a millisecond for a kite.
#pragma once

#include "look/fabric.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

class SunShade
{
public:
    static constexpr int side = 256; // pixels, of the picture

    // The fabric throws and gets the shade; what is not finite does neither.
    //     places   [particles]  m
    //     normals  [particles]  unit, to either side
    //     present  [panels]     1 for panels that count
    //     shade    [particles]  out, 0 in the sun to 1 in full shade
    void cast(std::span<const Vec3> places, std::span<const std::array<float, 3>> normals,
              std::span<const Corners> panels, std::span<const std::uint8_t> present,
              std::span<float> shade);

private:
    struct Spot // of a place, as the sun sees it
    {
        float across, up;                       // pixels
        float nearness;                         // pixels, towards the sun
        float riseAcross = 0.0F, riseUp = 0.0F; // 1, of the nearness of the plane there
        bool isOnEdge = false;                  // to the sun, which lights it no more
    };

    static bool isSeen(const Spot& spot);
    bool frame(std::span<const Vec3> places, std::span<const std::array<float, 3>> normals,
               std::span<const Corners> panels, std::span<const std::uint8_t> present);
    void draw(const Spot& a, const Spot& b, const Spot& c);
    float shadeOf(const Spot& spot) const;

    std::vector<Spot> m_spots;     // [particles]
    std::vector<float> m_nearness; // [side * side] pixels, of what is nearest to the sun
};

} // namespace ripstop
