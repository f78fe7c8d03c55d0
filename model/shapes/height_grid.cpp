// Ground from a grid of heights:
// 1. generatedHills() sums five octaves of smooth noise on a lattice and stretches the sum to 0 to
//    1. The noise is made of integer hashes, so that it is the same on every machine.
// 2. groundAt() interpolates bilinearly and takes the normal from the derivatives of the same
//    surface.
// 3. touchGround() follows a long way in steps of half a cell and halves the step in which it goes
//    below, so that a fast point does not jump over a hill. A deep touch belongs to the place of
//    entry, a light one to the nearest place; at last the point is raised along the normals until
//    the margin is kept.
#include "shapes/height_grid.h"

#include "base/split_mix.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double slack = 1e-9; // of the size: what round-off may do to a point that rests

// A random number from 0 to 1 for each point of a lattice.
double random(std::uint32_t seed, std::int64_t x, std::int64_t z)
{
    const std::uint64_t n = std::uint64_t(x) * 0x9E3779B97F4A7C15u
                            + std::uint64_t(z) * 0xC2B2AE3D27D4EB4Fu + seed * 0x165667B19E3779F9u;
    return double(mixBits(n) >> 11) * 0x1p-53;
}

// Random numbers on a lattice, joined with level tangents and a continuous curvature.
double noise(std::uint32_t seed, double x, double z)
{
    const double x0 = std::floor(x), z0 = std::floor(z);
    const auto eased = [](double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); };
    const double u = eased(x - x0), v = eased(z - z0);
    const auto i = std::int64_t(x0), k = std::int64_t(z0);
    const double near = (1.0 - u) * random(seed, i, k) + u * random(seed, i + 1, k);
    const double far = (1.0 - u) * random(seed, i, k + 1) + u * random(seed, i + 1, k + 1);
    return (1.0 - v) * near + v * far;
}

struct Above
{
    double distance; // m, over the tangent plane of the ground there; negative below it
    Ground ground;
};

Above above(const HeightGrid& grid, const Vec3& size, const Vec3& point)
{
    const Ground ground = groundAt(grid, size, point);
    return {(point.y() - ground.height) * ground.normal.y(), ground};
}

// Moves a touch out of the ground along its normals, and in the last try straight up.
Touch raised(const HeightGrid& grid, const Vec3& size, double margin, Touch touch)
{
    constexpr int tries = 4;
    for (int i = 0; i < tries && isOver(size, touch.surface); ++i) {
        const auto [distance, ground] = above(grid, size, touch.surface);
        const double missing = margin - distance;
        if (missing <= slack * size.maxCoeff())
            break;
        touch.normal = ground.normal;
        if (i + 1 < tries)
            touch.surface += missing * ground.normal;
        else
            touch.surface.y() += missing / ground.normal.y();
    }
    return touch;
}

double halfCells(const HeightGrid& grid, const Vec3& size, const Vec3& way)
{
    return 2.0
           * std::max(std::abs(way.x()) / size.x() * (grid.columns - 1),
                      std::abs(way.z()) / size.z() * (grid.rows - 1));
}

// The share of the way at which a point that was above is below for the first time, or nothing.
std::optional<double> entered(const HeightGrid& grid, const Vec3& size, const Vec3& from,
                              const Vec3& to)
{
    const Vec3 way = to - from;
    const int steps = 1 + int(std::min(halfCells(grid, size, way), 1e4));
    const auto isBelow = [&](double share) {
        const Vec3 point = from + share * way;
        return isOver(size, point) && point.y() < groundAt(grid, size, point).height;
    };
    for (int i = 1; i <= steps; ++i) {
        if (!isBelow(double(i) / steps))
            continue;
        double out = double(i - 1) / steps, in = double(i) / steps;
        for (int k = 0; k < 30; ++k)
            (isBelow(0.5 * (out + in)) ? in : out) = 0.5 * (out + in);
        return in;
    }
    return std::nullopt;
}

} // namespace

HeightGrid generatedHills(int grid, std::uint32_t seed, double length)
{
    HeightGrid hills{grid, grid, {}};
    hills.height.reserve(std::size_t(grid) * std::size_t(grid));
    for (int row = 0; row < grid; ++row)
        for (int column = 0; column < grid; ++column) {
            double sum = 0.0, share = 1.0;
            double scale = 1.0 / (length * (grid - 1));
            for (std::uint32_t octave = 0; octave < 5; ++octave) {
                sum += share * noise(seed + 1000 * octave, scale * column, scale * row);
                share *= 0.4;
                scale *= 2.0;
            }
            hills.height.push_back(sum);
        }
    const auto [low, high] = std::minmax_element(hills.height.begin(), hills.height.end());
    const double foot = *low, range = *high > *low ? *high - *low : 1.0;
    for (double& height : hills.height)
        height = (height - foot) / range;
    return hills;
}

bool isOver(const Vec3& size, const Vec3& point)
{
    return 2.0 * std::abs(point.x()) <= size.x() && 2.0 * std::abs(point.z()) <= size.z();
}

Ground groundAt(const HeightGrid& grid, const Vec3& size, const Vec3& point)
{
    const double x = std::clamp(point.x() / size.x() + 0.5, 0.0, 1.0) * (grid.columns - 1);
    const double z = std::clamp(point.z() / size.z() + 0.5, 0.0, 1.0) * (grid.rows - 1);
    const int column = std::min(int(x), grid.columns - 2);
    const int row = std::min(int(z), grid.rows - 2);
    const double u = x - column, v = z - row;
    const double a = grid.at(row, column), b = grid.at(row, column + 1);
    const double c = grid.at(row + 1, column), d = grid.at(row + 1, column + 1);
    const double near = a + u * (b - a), far = c + u * (d - c);
    const double left = a + v * (c - a), right = b + v * (d - b);
    const double alongX = size.y() * (right - left) * (grid.columns - 1) / size.x();
    const double alongZ = size.y() * (far - near) * (grid.rows - 1) / size.z();
    return {size.y() * (near + v * (far - near)), Vec3(-alongX, 1.0, -alongZ).normalized()};
}

std::optional<Touch> touchGround(const HeightGrid& grid, const Vec3& size, double margin,
                                 const Vec3& from, const Vec3& to)
{
    const bool isOverIt = isOver(size, to);
    const Above end = isOverIt ? above(grid, size, to) : Above{margin, {}};
    const bool isShort = halfCells(grid, size, to - from) < 1.0; // no hill lies in between
    if (isShort && end.distance >= margin)
        return std::nullopt;
    const bool cameFromAbove =
        !isOver(size, from)
        || above(grid, size, from).distance >= -(margin + slack * size.maxCoeff());
    if (cameFromAbove && !isShort)
        if (const std::optional<double> share = entered(grid, size, from, to)) {
            const Vec3 entry = from + *share * (to - from);
            const Vec3 normal = groundAt(grid, size, entry).normal;
            // light touches belong to the nearest place, deep ones to where they came in
            if (*share < 1.0 && !(isOverIt && end.ground.normal.dot(normal) > 0.9))
                return raised(grid, size, margin,
                              {to - ((to - entry).dot(normal) - margin) * normal, normal});
        }
    if (end.distance >= margin || !(cameFromAbove || to.y() >= 0.0))
        return std::nullopt;
    return raised(grid, size, margin,
                  {to + (margin - end.distance) * end.ground.normal, end.ground.normal});
}

} // namespace ripstop
