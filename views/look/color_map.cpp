#include "look/color_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// A colour in the cylindrical form of OKLab: lightness 0 .. 1, chroma, hue in degrees.
struct Lch
{
    double lightness;
    double chroma;
    double hueDegrees;
};

using Rgb = std::array<double, 3>; // linear

// Ottosson, "A perceptual color space for image processing", 2020.
Rgb linear(const Lch& lch)
{
    const double hue = lch.hueDegrees * std::numbers::pi / 180.0;
    const double a = lch.chroma * std::cos(hue), b = lch.chroma * std::sin(hue);
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lch.lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lch.lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lch.lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool isShowable(const Rgb& rgb)
{
    return std::ranges::all_of(rgb, [](double c) { return c >= -1e-4 && c <= 1.0 + 1e-4; });
}

std::uint8_t encoded(double c)
{
    c = std::clamp(c, 0.0, 1.0);
    const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
    return std::uint8_t(std::lround(255.0 * s));
}

// Reduces the chroma until the screen can show the colour.
Color toColor(Lch lch)
{
    while (lch.chroma > 0.0 && !isShowable(linear(lch)))
        lch.chroma -= 0.002;
    const Rgb rgb = linear(lch);
    return {encoded(rgb[0]), encoded(rgb[1]), encoded(rgb[2])};
}

} // namespace

const ColorMap& ColorMap::sequential()
{
    static const ColorMap map = [] {
        ColorMap made;
        for (int i = 0; i < steps; ++i) {
            const double t = double(i) / (steps - 1);
            made.m_colors[i] = toColor({0.30 + 0.63 * t, 0.145 + 0.03 * t, 295.0 - 190.0 * t});
        }
        return made;
    }();
    return map;
}

const ColorMap& ColorMap::diverging()
{
    static const ColorMap map = [] {
        ColorMap made;
        for (int i = 0; i < steps; ++i) {
            const double t = 2.0 * i / (steps - 1) - 1.0; // -1 .. 1
            const double strength = std::abs(t);
            made.m_colors[i] = toColor(
                {0.92 - 0.44 * strength, 0.20 * std::pow(strength, 0.8), t < 0.0 ? 255.0 : 30.0});
        }
        return made;
    }();
    return map;
}

Color ColorMap::at(double share) const
{
    if (std::isnan(share))
        return {128, 128, 128};
    return m_colors[std::size_t(std::lround(std::clamp(share, 0.0, 1.0) * (steps - 1)))];
}

} // namespace ripstop
