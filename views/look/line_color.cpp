#include "look/line_color.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// Relative luminance, 0 .. 1, and contrast of two, 1 .. 21 (WCAG 2.1, "relative luminance").
double luminance(const Color& color)
{
    const auto linear = [](std::uint8_t value) {
        const double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

double contrast(const Color& a, const Color& b)
{
    const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

Color mixed(const Color& color, std::uint8_t end, double share)
{
    Color mix{};
    for (std::size_t i = 0; i < 3; ++i)
        mix[i] = std::uint8_t(std::lround(color[i] + share * (end - color[i])));
    return mix;
}

} // namespace

Color lineColor(const Color& authored, const Theme& theme)
{
    // pale lines mostly run over coloured fabric, so that by day a little is enough
    const double enough = theme.isDark() ? 2.5 : 1.25;
    const std::uint8_t end = theme.isDark() ? 255 : 0;
    const Color sky{std::uint8_t(theme.skyBottom.red()), std::uint8_t(theme.skyBottom.green()),
                    std::uint8_t(theme.skyBottom.blue())};
    constexpr int steps = 20;
    Color shown = authored;
    for (int i = 1; i <= steps && contrast(shown, sky) < enough; ++i)
        shown = mixed(authored, end, double(i) / steps);
    return shown;
}

} // namespace ripstop
