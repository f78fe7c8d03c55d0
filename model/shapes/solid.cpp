// The rows of the table of shapes: first the answers that several shapes share, then those of one
// shape after the other, then the table in the order of the enumeration. Two static assertions
// make a shape without a row, or a row without an answer, fail to compile.
#include "shapes/solid.h"

#include "shapes/cylinder.h"
#include "shapes/round_shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace ripstop {
namespace {

using Box = Eigen::AlignedBox3d;

// --- what several shapes answer

Box around(const Vec3& half) { return {-half, half}; }
Box nowhere(const Solid&) { return {}; }
double wideByNature(const Solid&) { return std::numeric_limits<double>::infinity(); }
double acrossRadius(const Solid& solid) { return 2.0 * (solid.radius + solid.margin); }
Message sound(const Solid&) { return {}; }

std::vector<Vec3> cornersOf(const Box& box)
{
    std::vector<Vec3> corners;
    if (!box.isEmpty())
        for (int i = 0; i < 8; ++i)
            corners.push_back(box.corner(Box::CornerType(i)));
    return corners;
}

// --- one shape after the other

Message flawOfPlane(const Solid& solid)
{
    return solid.normal.norm() > 0.0 ? Message()
                                     : Message("Collider %1 needs a normal that is not zero.");
}

Box boundsOfSphere(const Solid& solid) { return around(Vec3::Constant(solid.radius)); }

std::vector<Vec3> extremesOfSphere(const Solid& solid)
{
    std::vector<Vec3> points;
    for (const int axis : {0, 1, 2})
        for (const double side : {-1.0, 1.0})
            points.push_back(side * solid.radius * Vec3::Unit(axis));
    return points;
}

Box boundsOfBox(const Solid& solid) { return around(0.5 * solid.size); }

// A wide sheet stops fabric however thin it is.
double widthOfBox(const Solid& solid)
{
    Vec3 size = solid.size + Vec3::Constant(2.0 * solid.margin);
    std::sort(size.begin(), size.end());
    return size.y();
}

Message flawOfBox(const Solid& solid)
{
    return solid.size.minCoeff() > 0.0
               ? Message()
               : Message("Collider %1 needs edges above 0: correct its size.");
}

// The second number of the size is the height.
Cylinder cylinderOf(const Solid& solid) { return {solid.radius, 0.5 * solid.size.y()}; }

Box boundsOfCylinder(const Solid& solid)
{
    return around({solid.radius, 0.5 * solid.size.y(), solid.radius});
}

Message flawOfCylinder(const Solid& solid)
{
    return solid.size.y() > 0.0
               ? Message()
               : Message(
                   "Collider %1 needs a height above 0: correct the second number of its size.");
}

Box boundsOfGround(const Solid& solid)
{
    const Vec3 half(0.5 * solid.size.x(), 0.0, 0.5 * solid.size.z());
    return {-half, half + Vec3(0.0, solid.size.y(), 0.0)};
}

Box boundsOfMesh(const Solid& solid)
{
    return solid.mesh ? Box(solid.scale * solid.mesh->low(), solid.scale * solid.mesh->high())
                      : Box();
}

std::optional<Touch> touchScaledMesh(const Solid& solid, const Vec3& from, const Vec3& to,
                                     bool inside)
{
    if (!solid.mesh)
        return std::nullopt;
    const double units = 1.0 / solid.scale;
    auto touch = touchMesh(*solid.mesh, units * solid.margin, units * from, units * to, inside);
    if (touch)
        touch->surface *= solid.scale;
    return touch;
}

ShapeSurface surfaceOfScaledMesh(const Solid& solid)
{
    if (!solid.mesh)
        return {};
    ShapeSurface surface = meshSurface(*solid.mesh);
    for (Vec3& point : surface.points)
        point *= solid.scale;
    return surface;
}

double rayToScaledMesh(const Solid& solid, const ShapeRay& ray)
{
    const double units = 1.0 / solid.scale;
    return solid.mesh ? rayToMesh(*solid.mesh, {units * ray.origin, units * ray.direction}) : noHit;
}

// --- the table: a row for each, in the order of the enumeration

constexpr auto rows = std::to_array<ShapeRow>({
    {
        .shape = ColliderShape::Plane,
        .uses = {.normal = true},
        .touch = nullptr,
        .bounds = nowhere,
        .width = wideByNature,
        .flaw = flawOfPlane,
        .surface = [](const Solid&) { return ShapeSurface(); },
        .ray = [](const Solid&, const ShapeRay&) { return noHit; },
        .extremes = [](const Solid&) { return std::vector<Vec3>(); },
    },
    {
        .shape = ColliderShape::Sphere,
        .uses = {.radius = true},
        .touch = [](const Solid& solid, const Vec3& from, const Vec3& to,
                    bool) { return touchSphere(solid.radius + solid.margin, from, to); },
        .bounds = boundsOfSphere,
        .width = acrossRadius,
        .flaw = sound,
        .surface = [](const Solid& solid) { return sphereSurface(drawnRadius * solid.radius); },
        .ray = [](const Solid& solid,
                  const ShapeRay& ray) { return rayToSphere(solid.radius, ray); },
        .extremes = extremesOfSphere,
    },
    {
        .shape = ColliderShape::Box,
        .uses = {.size = true, .turn = true},
        .touch = [](const Solid& solid, const Vec3& from, const Vec3& to,
                    bool) { return touchBox(0.5 * solid.size, solid.margin, from, to); },
        .bounds = boundsOfBox,
        .width = widthOfBox,
        .flaw = flawOfBox,
        .surface = [](const Solid& solid) { return boxSurface(0.5 * solid.size); },
        .ray = [](const Solid& solid,
                  const ShapeRay& ray) { return rayToBox(boundsOfBox(solid), ray); },
        .extremes = [](const Solid& solid) { return cornersOf(boundsOfBox(solid)); },
    },
    {
        .shape = ColliderShape::Cylinder,
        .uses = {.radius = true, .size = true, .turn = true},
        .round = Round::AboutY,
        .touch = [](const Solid& solid, const Vec3& from, const Vec3& to,
                    bool) { return touchCylinder(cylinderOf(solid), solid.margin, from, to); },
        .bounds = boundsOfCylinder,
        .width = acrossRadius, // a disc stops fabric however thin it is
        .flaw = flawOfCylinder,
        .surface =
            [](const Solid& solid) {
                return cylinderSurface({drawnRadius * solid.radius, 0.5 * solid.size.y()});
            },
        .ray = [](const Solid& solid,
                  const ShapeRay& ray) { return rayToCylinder(cylinderOf(solid), ray); },
        .extremes = [](const Solid& solid) { return cornersOf(boundsOfCylinder(solid)); },
    },
    {
        .shape = ColliderShape::HeightField,
        .uses = {.size = true, .turn = true, .file = true, .hills = true},
        .madeOf = MadeOf::Heights,
        .isGround = true,
        .touch =
            [](const Solid& solid, const Vec3& from, const Vec3& to, bool) {
                return solid.grid ? touchGround(*solid.grid, solid.size, solid.margin, from, to)
                                  : std::nullopt;
            },
        .bounds = boundsOfGround,
        .width = wideByNature,
        .flaw = sound,
        .surface =
            [](const Solid& solid) {
                return solid.grid ? groundSurface(*solid.grid, solid.size) : ShapeSurface();
            },
        .ray =
            [](const Solid& solid, const ShapeRay& ray) {
                return solid.grid ? rayToGround(*solid.grid, solid.size, ray) : noHit;
            },
        .extremes = [](const Solid& solid) { return cornersOf(boundsOfGround(solid)); },
    },
    {
        .shape = ColliderShape::Mesh,
        .uses = {.turn = true, .file = true, .scale = true},
        .madeOf = MadeOf::Triangles,
        .touch = touchScaledMesh,
        .bounds = boundsOfMesh,
        .width = wideByNature,
        .flaw = sound,
        .surface = surfaceOfScaledMesh,
        .ray = rayToScaledMesh,
        .extremes = [](const Solid& solid) { return cornersOf(boundsOfMesh(solid)); },
    },
});

static_assert(rows.size() == choiceNames<ColliderShape>.size(), "a row for each shape");

constexpr bool areWhole()
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ShapeRow& row = rows[i];
        if (row.shape != ColliderShape(i) || !row.bounds || !row.width || !row.flaw || !row.surface
            || !row.ray || !row.extremes || (!row.touch && row.shape != ColliderShape::Plane))
            return false;
    }
    return true;
}
static_assert(areWhole(), "rows in the order of the enumeration, each with every answer");

} // namespace

const ShapeRow& rowOf(ColliderShape shape)
{
    assert(std::size_t(shape) < rows.size());
    return rows[std::size_t(shape)];
}

} // namespace ripstop
