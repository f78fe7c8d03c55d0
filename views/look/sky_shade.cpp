// Shades and cosines are added up direction by direction, and divided at the end.
#include "look/sky_shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// Turns by the golden angle from pole to pole, in bands of equal area.
Vec3 directionOf(int i)
{
    const double height = 1.0 - (2.0 * i + 1.0) / SkyShade::directions;
    const double turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0)); // rad
    const double radius = std::sqrt(1.0 - height * height);
    return {radius * std::cos(turn), height, radius * std::sin(turn)};
}

} // namespace

void SkyShade::cast(std::span<const Vec3> places, std::span<const std::array<float, 3>> normals,
                    std::span<const Corners> panels, std::span<const std::uint8_t> present,
                    std::span<std::array<float, 2>> shade)
{
    m_shade.resize(places.size());
    m_light.assign(places.size(), {0.0F, 0.0F});
    std::ranges::fill(shade, std::array{0.0F, 0.0F});
    for (int i = 0; i < directions; ++i) {
        const Vec3 light = directionOf(i);
        m_self.cast(light, places, normals, panels, present, m_shade);
        for (std::size_t p = 0; p < places.size(); ++p) {
            const auto& [x, y, z] = normals[p];
            const auto cosine = float(light.x()) * x + float(light.y()) * y + float(light.z()) * z;
            if (!std::isfinite(cosine)) // a panel that has left for infinity
                continue;
            const std::size_t side = cosine > 0.0F ? 0 : 1;
            m_light[p][side] += std::abs(cosine);
            shade[p][side] += std::abs(cosine) * m_shade[p];
        }
    }
    for (std::size_t p = 0; p < places.size(); ++p)
        for (std::size_t side = 0; side < 2; ++side)
            if (m_light[p][side] > 0.0F)
                shade[p][side] /= m_light[p][side];
}

} // namespace ripstop
