// Ground whose height is a function of place: a grid of heights with bilinear cells.
//
// The field lies around the origin of its own frame: x from -size.x / 2 to size.x / 2, z likewise,
// and the surface at y = size.y times the height of the grid. Within a cell the height is
// h = a + b u + c v + d u v, and the normal is that of this surface, exactly. Below it the ground
// is solid down to y = 0; beyond its rim there is nothing.
#pragma once

#include "shapes/round_shapes.h"

#include <cstdint>
#include <vector>

namespace ripstop {

struct HeightGrid
{
    int columns = 0;            // along x, two or more
    int rows = 0;               // along z
    std::vector<double> height; // [rows x columns] 0 to 1, x running fastest

    double at(int row, int column) const
    {
        return height[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
    }

    friend bool operator==(const HeightGrid&, const HeightGrid&) = default;
};

// Hills from 0 to 1 of smooth noise in five octaves, the same on every machine: `grid` points along
// each side, and `length` from one of the largest hills to the next, over the width of the grid.
HeightGrid generatedHills(int grid, std::uint32_t seed, double length);

bool isOver(const Vec3& size, const Vec3& point); // between the rims
struct Ground
{
    double height; // m
    Vec3 normal;   // unit, upwards
};
Ground groundAt(const HeightGrid& grid, const Vec3& size, const Vec3& point);

// See touch.h. The way is followed in steps of half a cell.
std::optional<Touch> touchGround(const HeightGrid& grid, const Vec3& size, double margin,
                                 const Vec3& from, const Vec3& to);

} // namespace ripstop
