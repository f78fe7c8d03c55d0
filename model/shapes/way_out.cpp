// A touch without a way: the row of the shape is asked about a point that stays where it is.
#include "shapes/way_out.h"

#include "shapes/triangle_tree.h"

namespace ripstop {
namespace {

constexpr double lying = 1e-4; // m; designs are drawn, and files written, no finer than that

std::optional<Touch> touchAt(ColliderShape shape, const Solid& solid, const Vec3& point)
{
    if (shape != ColliderShape::Plane)
        return rowOf(shape).touch(solid, point, point, true);
    const double height = point.dot(solid.normal) - solid.margin;
    if (height >= 0.0)
        return std::nullopt;
    return Touch{point - height * solid.normal, solid.normal};
}

// A mesh keeps a margin of its own, within which a point lies on it.
double allowance(const Solid& solid)
{
    return solid.mesh
               ? lying + solid.scale * leastMargin * (solid.mesh->high() - solid.mesh->low()).norm()
               : lying;
}

} // namespace

std::optional<Touch> wayOut(ColliderShape shape, const Solid& solid, const Vec3& point)
{
    const auto touch = touchAt(shape, solid, point);
    return touch && (touch->surface - point).norm() > allowance(solid) ? touch : std::nullopt;
}

} // namespace ripstop
