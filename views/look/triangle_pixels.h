// The pixels of a triangle in a square picture, for shadows that are drawn without a graphics card.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ripstop {

// Visits each pixel whose middle lies in the triangle, seen from either side: its place in the rows
// of the picture, and the shares that the second and the third corner have there. Corners are in
// pixels; what lies beyond the picture is left out.
template <typename Visit> // visit(pixel, second, third)
void forEachPixel(int side, const std::array<std::array<float, 2>, 3>& corners, Visit visit)
{
    const auto& [a, b, c] = corners;
    const float twiceArea = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (twiceArea == 0.0F)
        return;
    const auto range = [&](std::size_t axis) {
        const auto [low, high] =
            std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
        return std::pair(std::max(0, int(std::ceil(low - 0.5F))),
                         std::min(side - 1, int(std::floor(high - 0.5F))));
    };
    const auto [left, right] = range(0);
    const auto [first, last] = range(1);
    for (int row = first; row <= last; ++row)
        for (int column = left; column <= right; ++column) {
            const float x = float(column) + 0.5F - a[0], y = float(row) + 0.5F - a[1];
            const float second = (x * (c[1] - a[1]) - y * (c[0] - a[0])) / twiceArea;
            const float third = (y * (b[0] - a[0]) - x * (b[1] - a[1])) / twiceArea;
            if (second >= 0.0F && third >= 0.0F && second + third <= 1.0F)
                visit(std::size_t(row * side + column), second, third);
        }
}

} // namespace ripstop
