// Planes are compared by height; other shapes are asked in their own frames. A reach is a margin
// that is added to the shape, and taken from the surface that is found.
#include "contact/obstacle_touch.h"

#include "shapes/triangle_tree.h"

#include <algorithm>

namespace ripstop {
namespace {

std::optional<Touch> touchPlane(const Obstacle& obstacle, const Vec3& position, const Vec3& to,
                                double reach)
{
    const double height = (to - position).dot(obstacle.normal) - obstacle.thickness;
    if (height >= reach)
        return std::nullopt;
    return Touch{to - height * obstacle.normal, obstacle.normal};
}

std::optional<Touch> touchSolid(const Obstacle& obstacle, const Vec3& position,
                                const Passage& passage, const Solid& solid, bool inside)
{
    const ShapeRow& row = rowOf(obstacle.shape);
    const Vec3 from = passage.from - position, to = passage.to - position;
    const Eigen::Matrix3d& turn = obstacle.turn;
    const bool turns = row.uses.turn;
    std::optional<Touch> touch =
        turns ? row.touch(solid, turn.transpose() * from, turn.transpose() * to, inside)
              : row.touch(solid, from, to, inside);
    if (touch && turns)
        touch = Touch{turn * touch->surface, turn * touch->normal};
    if (touch)
        touch->surface += position;
    return touch;
}

// What a margin more really adds: a mesh keeps some in any case.
double added(const Solid& solid, double reach)
{
    if (!solid.mesh)
        return reach;
    const double least = leastMargin * (solid.mesh->high() - solid.mesh->low()).norm();
    return std::max(solid.margin + reach, least) - std::max(solid.margin, least);
}

} // namespace

std::optional<Touch> touched(const Obstacle& obstacle, const PlacedObstacle& placed,
                             const Passage& passage, bool inside)
{
    if (obstacle.shape == ColliderShape::Plane)
        return touchPlane(obstacle, placed.position, passage.to, 0.0);
    return touchSolid(obstacle, placed.position, passage, placed.solid, inside);
}

std::optional<Touch> surfaceNear(const Obstacle& obstacle, const PlacedObstacle& placed,
                                 const Passage& passage, double reach)
{
    if (obstacle.shape == ColliderShape::Plane)
        return touchPlane(obstacle, placed.position, passage.to, reach);
    Solid solid = placed.solid;
    solid.margin += reach;
    std::optional<Touch> touch = touchSolid(obstacle, placed.position, passage, solid, false);
    if (touch)
        touch->surface -= added(placed.solid, reach) * touch->normal;
    return touch;
}

} // namespace ripstop
