#include "plots/curve_color.h"

#include <array>

namespace ripstop {
namespace {

// Okabe and Ito 2008, in their order of use, darkened on white and lightened on black where the
// contrast asks for it (at least 3 : 1).
constexpr std::array<QRgb, 8> onLight{0xff0072b2, 0xffd55e00, 0xff008a66, 0xffb84f8c,
                                      0xff9a7400, 0xff3a87ad, 0xff6a3fa0, 0xff444444};
constexpr std::array<QRgb, 8> onDark{0xff56b4e9, 0xffff8a3d, 0xff2fc79a, 0xffe69ac6,
                                     0xfff0e442, 0xff8fb8ff, 0xffb79cf2, 0xffd0d0d0};

} // namespace

bool isDark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

QColor curveColor(int n, const QPalette& palette)
{
    const auto& colors = isDark(palette) ? onDark : onLight;
    const QColor color(colors[std::size_t(n) % colors.size()]);
    const bool isShade = std::size_t(n) / colors.size() % 2 == 1;
    if (!isShade)
        return color;
    const float lightness = color.lightnessF() * (isDark(palette) ? 0.8F : 0.55F);
    return QColor::fromHslF(color.hslHueF(), color.hslSaturationF(), lightness);
}

} // namespace ripstop
