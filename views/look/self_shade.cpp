// cast() has three parts: frame() fits the picture and finds the plane of the fabric at each
// corner, draw() fills the picture triangle by triangle, and shadeOf() looks around each place.
#include "look/self_shade.h"

#include "look/triangle_pixels.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr int reach = 2;             // pixels around a place that are looked at
constexpr double leastFacing = 0.05; // 1, of a plane that the light reaches at all
constexpr float sameSurface = 4.0F;  // pixels
constexpr float leastSize = 1e-3F;   // m
constexpr float farthest = 1e30F;    // m, that can still be reckoned with
constexpr float notSeen = std::numeric_limits<float>::lowest(); // of a place or a pixel

} // namespace

bool SelfShade::isSeen(const Spot& spot) { return spot.nearness != notSeen; }

// Puts the picture around the corners of panels, and says where each of them is in it. Returns
// false where there are none.
bool SelfShade::frame(const Vec3& light, std::span<const Vec3> places,
                      std::span<const std::array<float, 3>> normals,
                      std::span<const Corners> panels, std::span<const std::uint8_t> present)
{
    const Vec3 across = light.unitOrthogonal();
    const Vec3 up = light.cross(across);
    m_spots.assign(places.size(), {0.0F, 0.0F, notSeen});
    Eigen::AlignedBox2f box;
    for (std::size_t i = 0; i < panels.size(); ++i)
        for (const int corner : panels[i]) {
            const Vec3& place = places[std::size_t(corner)];
            Spot& spot = m_spots[std::size_t(corner)];
            if (!present[i] || isSeen(spot))
                continue;
            const Eigen::Vector3f seen( // m
                float(across.dot(place)), float(up.dot(place)), float(light.dot(place)));
            if (!seen.allFinite() || seen.cwiseAbs().maxCoeff() >= farthest)
                continue;
            spot = {seen.x(), seen.y(), seen.z()};
            const auto& [x, y, z] = normals[std::size_t(corner)];
            const Vec3 normal(x, y, z);
            const double facing = normal.dot(light);
            spot.isOnEdge = std::abs(facing) < leastFacing;
            spot.riseAcross = float(-normal.dot(across) / facing);
            spot.riseUp = float(-normal.dot(up) / facing);
            box.extend(Eigen::Vector2f(spot.across, spot.up));
        }
    if (box.isEmpty())
        return false;
    const float room = reach + 1.0F; // pixels
    const float perMetre =
        (float(m_side) - 2.0F * room) / std::max(box.sizes().maxCoeff(), leastSize);
    for (Spot& spot : m_spots)
        if (isSeen(spot)) {
            spot.across = room + perMetre * (spot.across - box.min().x());
            spot.up = room + perMetre * (spot.up - box.min().y());
            spot.nearness *= perMetre;
        }
    return true;
}

void SelfShade::draw(const Spot& a, const Spot& b, const Spot& c)
{
    if (!isSeen(a) || !isSeen(b) || !isSeen(c))
        return;
    forEachPixel(m_side, {{{a.across, a.up}, {b.across, b.up}, {c.across, c.up}}},
                 [&](std::size_t pixel, float ofB, float ofC) {
                     m_nearness[pixel] =
                         std::max(m_nearness[pixel], a.nearness + ofB * (b.nearness - a.nearness)
                                                         + ofC * (c.nearness - a.nearness));
                 });
}

float SelfShade::shadeOf(const Spot& spot) const
{
    if (!isSeen(spot) || spot.isOnEdge)
        return 0.0F;
    const int column = int(spot.across), row = int(spot.up);
    int count = 0;
    for (int y = row - reach; y <= row + reach; ++y)
        for (int x = column - reach; x <= column + reach; ++x) {
            const float plane = spot.nearness + spot.riseAcross * (float(x) + 0.5F - spot.across)
                                + spot.riseUp * (float(y) + 0.5F - spot.up);
            count += m_nearness[std::size_t(y * m_side + x)] > plane + sameSurface;
        }
    constexpr int all = (2 * reach + 1) * (2 * reach + 1);
    return float(count) / float(all);
}

void SelfShade::cast(const Vec3& light, std::span<const Vec3> places,
                     std::span<const std::array<float, 3>> normals, std::span<const Corners> panels,
                     std::span<const std::uint8_t> present, std::span<float> shade)
{
    std::ranges::fill(shade, 0.0F);
    if (!frame(light, places, normals, panels, present))
        return;
    m_nearness.assign(std::size_t(m_side) * std::size_t(m_side), notSeen);
    for (std::size_t i = 0; i < panels.size(); ++i)
        if (present[i]) {
            const auto& [a, b, c] = panels[i];
            draw(m_spots[std::size_t(a)], m_spots[std::size_t(b)], m_spots[std::size_t(c)]);
        }
    std::ranges::transform(m_spots, shade.begin(),
                           [this](const Spot& spot) { return shadeOf(spot); });
}

} // namespace ripstop
