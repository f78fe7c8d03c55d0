#include "viewport/collider_geometry.h"

#include "scene/collider_shape.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// A panel that rests on a sphere with its corners dips into it with its middle; drawn a little
// smaller, the sphere does not show through.
constexpr double drawnSize = 0.965;

void fillGround(const HeightGrid& grid, const Vec3& size, vtkPolyData& data)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            Vec3 place(size.x() * (double(column) / (grid.columns - 1) - 0.5), 0.0,
                       size.z() * (double(row) / (grid.rows - 1) - 0.5));
            const Ground ground = groundAt(grid, size, place);
            place.y() = size.y() * grid.at(row, column);
            points->InsertNextPoint(place.data());
            normals->InsertNextTuple(ground.normal.data());
        }
    const auto at = [&](int row, int column) { return vtkIdType(row) * grid.columns + column; };
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column)
            cells->InsertNextCell({at(row, column), at(row + 1, column), at(row + 1, column + 1),
                                   at(row, column + 1)});
    data.SetPoints(points);
    data.SetPolys(cells);
    data.GetPointData()->SetNormals(normals);
}

void fillMesh(const TriangleTree& mesh, vtkPolyData& data)
{
    vtkNew<vtkPolyData> plain;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const Vec3& point : mesh.points())
        points->InsertNextPoint(point.data());
    for (const TriangleTree::Face& face : mesh.faces())
        cells->InsertNextCell({face.corner[0], face.corner[1], face.corner[2]});
    plain->SetPoints(points);
    plain->SetPolys(cells);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(plain);
    normals->SetFeatureAngle(40.0);
    normals->Update();
    data.ShallowCopy(normals->GetOutput());
}

// Where a ray enters a box, m along it.
double distanceToBox(const Eigen::AlignedBox3d& box, const Vec3& origin, const Vec3& direction)
{
    double in = 0.0, out = never;
    for (int i = 0; i < 3; ++i) {
        const double a = (box.min()[i] - origin[i]) / direction[i];
        const double b = (box.max()[i] - origin[i]) / direction[i];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in <= out ? in : never;
}

double distanceToSphere(double radius, const Vec3& origin, const Vec3& direction)
{
    const double b = origin.dot(direction);
    const double root = b * b - origin.squaredNorm() + radius * radius;
    return root >= 0.0 && -b - std::sqrt(root) > 0.0 ? -b - std::sqrt(root) : never;
}

double distanceToGround(const HeightGrid& grid, const Vec3& size, const Eigen::AlignedBox3d& bounds,
                        const Vec3& origin, const Vec3& direction)
{
    const double start = distanceToBox(bounds, origin, direction);
    if (start == never)
        return never;
    const double step = 0.5 * std::min(size.x() / grid.columns, size.z() / grid.rows);
    for (double t = start; t < start + bounds.diagonal().norm(); t += step) {
        const Vec3 point = origin + t * direction;
        if (isOver(size, point) && point.y() <= groundAt(grid, size, point).height)
            return t;
    }
    return never;
}

} // namespace

Vec3 placeOf(const Frame& frame, Id id, const Collider& collider)
{
    if (!frame.layout)
        return collider.position;
    const auto& ids = frame.layout->colliderId;
    const auto found = std::find(ids.begin(), ids.end(), std::uint32_t(id));
    const auto index = std::size_t(found - ids.begin());
    return index < frame.colliderPosition.size() ? frame.colliderPosition[index]
                                                 : collider.position;
}

vtkNew<vtkPolyData> surfaceOf(const Scene& scene, const Collider& collider)
{
    vtkNew<vtkPolyData> data;
    if (collider.shape == ColliderShape::Sphere) {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetRadius(drawnSize * collider.radius);
        sphere->SetThetaResolution(72);
        sphere->SetPhiResolution(48);
        sphere->Update();
        data->ShallowCopy(sphere->GetOutput());
    } else if (collider.shape == ColliderShape::Box) {
        vtkNew<vtkCubeSource> cube;
        cube->SetXLength(collider.size.x());
        cube->SetYLength(collider.size.y());
        cube->SetZLength(collider.size.z());
        cube->Update();
        data->ShallowCopy(cube->GetOutput());
    } else if (collider.shape == ColliderShape::HeightField) {
        if (const auto grid = gridOf(scene, collider))
            fillGround(**grid, collider.size, *data);
    } else if (collider.shape == ColliderShape::Mesh) {
        if (const auto mesh = meshOf(scene, collider))
            fillMesh(**mesh, *data);
    }
    return data;
}

Eigen::Matrix3d turnAndScale(const Collider& collider)
{
    switch (collider.shape) {
    case ColliderShape::Mesh:
        return collider.scale * turnOf(collider);
    case ColliderShape::Box:
    case ColliderShape::HeightField:
        return turnOf(collider);
    case ColliderShape::Plane:
    case ColliderShape::Sphere:
        break;
    }
    return Eigen::Matrix3d::Identity();
}

Eigen::AlignedBox3d boundsOf(const Scene& scene, const Collider& collider)
{
    switch (collider.shape) {
    case ColliderShape::Sphere:
        return {Vec3::Constant(-collider.radius), Vec3::Constant(collider.radius)};
    case ColliderShape::Box:
        return {-0.5 * collider.size, 0.5 * collider.size};
    case ColliderShape::HeightField: {
        const Vec3 half(0.5 * collider.size.x(), 0.0, 0.5 * collider.size.z());
        return {-half, half + Vec3(0.0, collider.size.y(), 0.0)};
    }
    case ColliderShape::Mesh:
        if (const auto mesh = meshOf(scene, collider))
            return {(*mesh)->low(), (*mesh)->high()};
        break;
    case ColliderShape::Plane:
        break;
    }
    return {};
}

std::vector<Vec3> cornersOf(const Scene& scene, const Collider& collider, const Vec3& place)
{
    std::vector<Vec3> corners;
    const Eigen::AlignedBox3d bounds = boundsOf(scene, collider);
    if (!bounds.isEmpty())
        for (int i = 0; i < 8; ++i)
            corners.push_back(
                place + turnAndScale(collider) * bounds.corner(Eigen::AlignedBox3d::CornerType(i)));
    return corners;
}

double distanceTo(const Scene& scene, const Collider& collider, const Vec3& place,
                  const Vec3& origin, const Vec3& direction)
{
    const Eigen::Matrix3d toOwn = turnAndScale(collider).inverse();
    const Vec3 from = toOwn * (origin - place);
    const Vec3 way = toOwn * direction;
    const Eigen::AlignedBox3d bounds = boundsOf(scene, collider);
    switch (collider.shape) {
    case ColliderShape::Sphere:
        return distanceToSphere(collider.radius, from, way);
    case ColliderShape::Box:
        return distanceToBox(bounds, from, way);
    case ColliderShape::HeightField:
        if (const auto grid = gridOf(scene, collider))
            return distanceToGround(**grid, collider.size, bounds, from, way);
        break;
    case ColliderShape::Mesh:
        if (const auto mesh = meshOf(scene, collider)) {
            const double far = (bounds.center() - from).norm() + bounds.diagonal().norm();
            const double length = far / way.norm(); // m in the scene
            if (const auto hit = (*mesh)->firstHit(from, from + length * way))
                return hit->share * length;
        }
        break;
    case ColliderShape::Plane:
        break;
    }
    return never;
}

} // namespace ripstop
