// From the authored collider to a solid, in the order of the header: its turn as a matrix, the
// heights or triangles that its row in the table of shapes is made of, and the solid that points
// at them. Then what depends on more than the shape: its errors (path, numbers, file, in this
// order).
#include "derived/collider_shape.h"

#include "scene/collider_path.h"
#include "scene/property.h"

#include <Eigen/Geometry>

#include <numbers>

namespace ripstop {

Eigen::Matrix3d turnOf(const Collider& collider)
{
    const Vec3 angle = collider.turn * (std::numbers::pi / 180.0);
    return (Eigen::AngleAxisd(angle.z(), Vec3::UnitZ())
            * Eigen::AngleAxisd(angle.y(), Vec3::UnitY())
            * Eigen::AngleAxisd(angle.x(), Vec3::UnitX()))
        .toRotationMatrix();
}

Result<std::shared_ptr<const HeightGrid>> gridOf(const Scene& scene, const Collider& collider,
                                                 Effort effort)
{
    const Vec3& size = collider.size;
    if (!(size.x() > 0.0 && size.y() >= 0.0 && size.z() > 0.0 && size.allFinite()))
        return Failure{"It needs a width and a depth above 0 and a height of at least 0: correct "
                       "its size."};
    if (collider.file.empty())
        return hills(collider.grid, std::uint32_t(collider.seed), collider.hillLength, effort);
    return heightsFromFile(placeOfFile(scene.folder.path, collider.file), effort);
}

Result<std::shared_ptr<const TriangleTree>> meshOf(const Scene& scene, const Collider& collider,
                                                   Effort effort)
{
    if (collider.file.empty())
        return Failure{"It needs a mesh: set its file to an OBJ, STL or PLY."};
    return meshFromFile(placeOfFile(scene.folder.path, collider.file), effort);
}

Result<ShapeData> shapeDataOf(const Scene& scene, const Collider& collider, Effort effort)
{
    ShapeData data;
    switch (rowOf(collider.shape).madeOf) {
    case MadeOf::Numbers:
        break;
    case MadeOf::Heights: {
        const auto grid = gridOf(scene, collider, effort);
        if (!grid)
            return grid.failure();
        data.grid = *grid;
        break;
    }
    case MadeOf::Triangles: {
        const auto mesh = meshOf(scene, collider, effort);
        if (!mesh)
            return mesh.failure();
        data.mesh = *mesh;
        break;
    }
    }
    return data;
}

Solid solidOf(const Collider& collider, const ShapeData& data)
{
    return {.normal = collider.normal,
            .radius = collider.radius,
            .size = collider.size,
            .scale = collider.scale,
            .margin = collider.thickness,
            .grid = data.grid.get(),
            .mesh = data.mesh.get()};
}

std::optional<Message> colliderError(const Scene& scene, const Collider& collider)
{
    if (const auto path = pathFromText(collider.path); !path)
        return Message("Collider %1: its path %2.", collider.name, path.message());
    if (const Message flaw = rowOf(collider.shape).flaw(solidOf(collider)); !flaw.empty())
        return flaw.with(collider.name);
    if (const auto data = shapeDataOf(scene, collider); !data)
        return Message("Collider %1: %2", collider.name, data.message());
    return std::nullopt;
}

double widthOf(const Collider& collider) { return rowOf(collider.shape).width(solidOf(collider)); }

bool mayLieOn(const Scene& scene, const Collider& collider, const Vec3& place, double within)
{
    const double reach = within + collider.thickness;
    const Vec3 away = place - collider.position;
    if (collider.shape == ColliderShape::Plane)
        return away.dot(collider.normal.normalized()) < reach;
    const auto data = shapeDataOf(scene, collider);
    const Eigen::AlignedBox3d box =
        data ? rowOf(collider.shape).bounds(solidOf(collider, *data)) : Eigen::AlignedBox3d();
    const Vec3 own = turnOf(collider).transpose() * away;
    return box.isEmpty() || box.exteriorDistance(own) < reach;
}

} // namespace ripstop
