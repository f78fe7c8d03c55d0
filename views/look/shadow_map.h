// The shadow of things on level ground, as a small picture of how dark the ground is.
//
// The sun is a disc, so that an edge which lies s along the ray from the ground has a penumbra as
// wide as s times the width of the disc: a sheet on the ground has a sharp shadow, a glider a
// blurred one. The disc is wider than the true one of 0.53 degrees, as through haze. What comes
// near the ground also keeps the light of the sky from it, whichever way the sun stands: that is
// the dark foot by which things are seen to touch.
//
// Triangles are drawn into layers by their height, each layer is blurred as its height asks, and
// the layers add up. All of it runs on the calling thread, in about a millisecond for a kite.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

// Direction towards the sun, not of unit length. The stage places its light there, too.
inline const Vec3 sunDirection(0.45, 1.0, 0.55);

inline constexpr double sunWidth = 0.02; // rad

class ShadowMap
{
public:
    static constexpr int side = 256; // pixels

    // Triangles are of indices of places, m; what lies below the ground throws no shadow.
    void cast(std::span<const Vec3> places, std::span<const std::array<int, 3>> triangles,
              double ground); // m

    bool isEmpty() const { return m_size == 0.0; }
    double x() const { return m_x; }       // m, of its first column
    double z() const { return m_z; }       // m, of its first row
    double size() const { return m_size; } // m, along both

    // [side * side] rows along z; 255 is without any light.
    const std::vector<std::uint8_t>& dark() const { return m_dark; }
    double darkAt(double x, double z) const; // 0 .. 1, between the pixels around that place, m

    // The same where `other` is drawn, too: what that has darkened already is darkened further only
    // as far as it is lighter there, as what lies in one shadow gets no darker by another.
    std::vector<std::uint8_t> darkBeside(const ShadowMap& other) const;

private:
    using Sheet = std::vector<float>; // [side * side]
    struct Spot                       // of a place on the ground
    {
        float x, z;   // pixels
        float height; // m over the ground
    };
    struct Layer
    {
        Sheet sheet;
        double width = 0.0; // pixels, of its penumbras, summed over its triangles
        int count = 0;
    };

    void frame(std::span<const Vec3> places, std::span<const std::array<int, 3>> triangles,
               double ground);
    void drawInLayers(std::span<const std::array<int, 3>> triangles);
    void drawFoot(std::span<const Vec3> places, std::span<const std::array<int, 3>> triangles,
                  double ground);
    void blur(Sheet& sheet, double width);
    void put();

    double m_x = 0.0, m_z = 0.0, m_size = 0.0;
    std::vector<Spot> m_spots; // [places]
    std::array<Layer, 6> m_layers;
    Layer m_foot;
    Sheet m_scratch;
    std::vector<std::uint8_t> m_dark;
};

} // namespace ripstop
