// How shapes are drawn and where rays meet them. Surfaces come first: a sphere of 72 meridians and
// 48 circles, a box with sharp edges, ground thinned to what can be told apart, and a mesh as it
// is. Rays follow: sphere and box in closed form, the ground in steps of half a cell between the
// sides of its box, and a mesh by its tree.
#include "shapes/shape_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace ripstop {
namespace {

// --- round shapes

constexpr int meridians = 72;
constexpr int circles = 48; // of latitude, the poles among them

// --- hills

constexpr int mostDrawn = 512; // points along each side of a height field

// The rows or columns of a grid that are drawn: all, or as many as the eye can tell apart.
std::vector<int> drawnOf(int count)
{
    const int pieces = std::min(count, mostDrawn) - 1;
    std::vector<int> drawn;
    for (int i = 0; i <= pieces; ++i)
        drawn.push_back(int(std::int64_t(i) * (count - 1) / pieces));
    return drawn;
}

// --- rays

struct Stretch
{
    double in, out; // along a ray; infinite when it misses
};

// Where a ray enters a box and leaves it.
Stretch within(const Eigen::AlignedBox3d& box, const ShapeRay& ray)
{
    double in = 0.0, out = noHit;
    for (int i = 0; i < 3; ++i) {
        const double a = (box.min()[i] - ray.origin[i]) / ray.direction[i];
        const double b = (box.max()[i] - ray.origin[i]) / ray.direction[i];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in <= out ? Stretch{in, out} : Stretch{noHit, noHit};
}

} // namespace

ShapeSurface sphereSurface(double radius)
{
    ShapeSurface surface;
    const auto add = [&](const Vec3& normal) {
        surface.points.push_back(radius * normal);
        surface.normals.push_back(normal);
    };
    add(Vec3::UnitZ());
    add(-Vec3::UnitZ());
    for (int meridian = 0; meridian < meridians; ++meridian)
        for (int circle = 1; circle < circles - 1; ++circle) {
            const double around = 2.0 * std::numbers::pi * meridian / meridians;
            const double down = std::numbers::pi * circle / (circles - 1);
            add({std::sin(down) * std::cos(around), std::sin(down) * std::sin(around),
                 std::cos(down)});
        }
    const auto at = [](int meridian, int circle) {
        return 2 + (meridian % meridians) * (circles - 2) + circle - 1;
    };
    for (int i = 0; i < meridians; ++i) {
        surface.faces.push_back({0, at(i, 1), at(i + 1, 1), -1});
        surface.faces.push_back({1, at(i + 1, circles - 2), at(i, circles - 2), -1});
        for (int j = 1; j < circles - 2; ++j) {
            surface.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1), -1});
            surface.faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j), -1});
        }
    }
    return surface;
}

ShapeSurface boxSurface(const Vec3& half)
{
    ShapeSurface surface;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const Vec3 normal = side * Vec3::Unit(axis);
            const Vec3 across = Vec3::Unit((axis + 1) % 3), up = normal.cross(across);
            const int first = int(surface.points.size());
            for (const auto& [a, b] :
                 {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
                surface.points.push_back((normal + a * across + b * up).cwiseProduct(half));
                surface.normals.push_back(normal);
            }
            surface.faces.push_back({first, first + 1, first + 2, first + 3});
        }
    return surface;
}

ShapeSurface groundSurface(const HeightGrid& grid, const Vec3& size)
{
    ShapeSurface surface;
    const std::vector<int> rows = drawnOf(grid.rows), columns = drawnOf(grid.columns);
    for (const int row : rows)
        for (const int column : columns) {
            Vec3 place(size.x() * (double(column) / (grid.columns - 1) - 0.5), 0.0,
                       size.z() * (double(row) / (grid.rows - 1) - 0.5));
            surface.normals.push_back(groundAt(grid, size, place).normal);
            place.y() = size.y() * grid.at(row, column);
            surface.points.push_back(place);
        }
    const int across = int(columns.size());
    for (int row = 0; row + 1 < int(rows.size()); ++row)
        for (int column = 0; column + 1 < across; ++column) {
            const int at = row * across + column;
            surface.faces.push_back({at, at + across, at + across + 1, at + 1});
        }
    return surface;
}

ShapeSurface meshSurface(const TriangleTree& mesh)
{
    ShapeSurface surface;
    surface.points = mesh.points();
    for (const TriangleTree::Face& face : mesh.faces())
        surface.faces.push_back({face.corner[0], face.corner[1], face.corner[2], -1});
    return surface;
}

double rayToSphere(double radius, const ShapeRay& ray)
{
    const auto& [origin, direction] = ray;
    const double b = origin.dot(direction);
    const double root = b * b - origin.squaredNorm() + radius * radius;
    return root >= 0.0 && -b - std::sqrt(root) > 0.0 ? -b - std::sqrt(root) : noHit;
}

double rayToBox(const Eigen::AlignedBox3d& box, const ShapeRay& ray) { return within(box, ray).in; }

double rayToGround(const HeightGrid& grid, const Vec3& size, const ShapeRay& ray)
{
    const Vec3 half(0.5 * size.x(), 0.0, 0.5 * size.z());
    const auto [in, out] = within(Eigen::AlignedBox3d(-half, half + Vec3(0.0, size.y(), 0.0)), ray);
    if (in == noHit)
        return noHit;
    const Vec3 way = (out - in) * ray.direction; // at most once across the field
    const double cells = std::max(std::abs(way.x()) / size.x() * grid.columns,
                                  std::abs(way.z()) / size.z() * grid.rows);
    const int steps = 1 + int(std::ceil(2.0 * cells));
    for (int i = 0; i <= steps; ++i) {
        const double t = in + (out - in) * i / steps;
        const Vec3 point = ray.origin + t * ray.direction;
        if (isOver(size, point) && point.y() <= groundAt(grid, size, point).height)
            return t;
    }
    return noHit;
}

double rayToMesh(const TriangleTree& mesh, const ShapeRay& ray)
{
    const Eigen::AlignedBox3d box(mesh.low(), mesh.high());
    const double far = (box.center() - ray.origin).norm() + box.diagonal().norm();
    const double length = far / ray.direction.norm();
    const auto hit = mesh.firstHit(ray.origin, ray.origin + length * ray.direction);
    return hit ? hit->share * length : noHit;
}

} // namespace ripstop
