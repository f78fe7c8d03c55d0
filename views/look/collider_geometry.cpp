#include "look/collider_geometry.h"

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
#include <cstdint>
#include <limits>

namespace ripstop {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// A panel that rests on a sphere with its corners dips into it with its middle; drawn a little
// smaller, the sphere does not show through.
constexpr double drawnSize = 0.965;

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

vtkSmartPointer<vtkPolyData> surfaceOf(const HeightGrid& grid, const Vec3& size)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    const std::vector<int> rows = drawnOf(grid.rows), columns = drawnOf(grid.columns);
    for (const int row : rows)
        for (const int column : columns) {
            Vec3 place(size.x() * (double(column) / (grid.columns - 1) - 0.5), 0.0,
                       size.z() * (double(row) / (grid.rows - 1) - 0.5));
            const Ground ground = groundAt(grid, size, place);
            place.y() = size.y() * grid.at(row, column);
            points->InsertNextPoint(place.data());
            normals->InsertNextTuple(ground.normal.data());
        }
    const auto across = vtkIdType(columns.size());
    for (vtkIdType row = 0; row + 1 < vtkIdType(rows.size()); ++row)
        for (vtkIdType column = 0; column + 1 < across; ++column) {
            const vtkIdType at = row * across + column;
            cells->InsertNextCell({at, at + across, at + across + 1, at + 1});
        }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(normals);
    return data;
}

vtkSmartPointer<vtkPolyData> surfaceOf(const TriangleTree& mesh)
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
    return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> surfaceOf(const ColliderBody& body)
{
    const Collider& collider = body.collider;
    if (collider.shape == ColliderShape::Sphere) {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetRadius(drawnSize * collider.radius);
        sphere->SetThetaResolution(72);
        sphere->SetPhiResolution(48);
        sphere->Update();
        return sphere->GetOutput();
    }
    if (collider.shape == ColliderShape::Box && !body.bounds.isEmpty()) {
        vtkNew<vtkCubeSource> cube;
        cube->SetXLength(collider.size.x());
        cube->SetYLength(collider.size.y());
        cube->SetZLength(collider.size.z());
        cube->Update();
        return cube->GetOutput();
    }
    if (body.grid)
        return surfaceOf(*body.grid, collider.size);
    return body.mesh ? surfaceOf(*body.mesh) : nullptr;
}

Eigen::AlignedBox3d boundsOf(const ColliderBody& body)
{
    const Collider& collider = body.collider;
    if (collider.shape == ColliderShape::Sphere)
        return {Vec3::Constant(-collider.radius), Vec3::Constant(collider.radius)};
    if (collider.shape == ColliderShape::Box)
        return {-0.5 * collider.size, 0.5 * collider.size};
    if (body.grid || (body.isLate && collider.shape == ColliderShape::HeightField)) {
        const Vec3 half(0.5 * collider.size.x(), 0.0, 0.5 * collider.size.z());
        return {-half, half + Vec3(0.0, collider.size.y(), 0.0)};
    }
    if (body.mesh)
        return {body.mesh->low(), body.mesh->high()};
    return {};
}

ColliderBody bodyOf(const Scene& scene, Id id, const Collider& collider, const ColliderBody* before)
{
    ColliderBody body;
    body.id = id;
    body.collider = collider;
    if (collider.shape == ColliderShape::HeightField)
        if (const auto grid = gridOf(scene, collider, Effort::None)) {
            body.isLate = !*grid;
            body.grid = body.isLate && before ? before->grid : *grid;
        }
    if (collider.shape == ColliderShape::Mesh)
        if (const auto mesh = meshOf(scene, collider, Effort::None)) {
            body.isLate = !*mesh;
            body.mesh = body.isLate && before ? before->mesh : *mesh;
        }
    body.bounds = boundsOf(body);
    return body;
}

bool looksAlike(const ColliderBody& a, const ColliderBody& b)
{
    return a.collider.shape == b.collider.shape && a.collider.radius == b.collider.radius
           && a.collider.size == b.collider.size && a.grid == b.grid && a.mesh == b.mesh;
}

struct Stretch
{
    double in, out; // m along a ray; infinite when it misses
};

// Where a ray enters a box and leaves it.
Stretch within(const Eigen::AlignedBox3d& box, const Vec3& origin, const Vec3& direction)
{
    double in = 0.0, out = never;
    for (int i = 0; i < 3; ++i) {
        const double a = (box.min()[i] - origin[i]) / direction[i];
        const double b = (box.max()[i] - origin[i]) / direction[i];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    return in <= out ? Stretch{in, out} : Stretch{never, never};
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
    const auto [in, out] = within(bounds, origin, direction);
    if (in == never)
        return never;
    const Vec3 way = (out - in) * direction; // at most once across the field
    const double cells = std::max(std::abs(way.x()) / size.x() * grid.columns,
                                  std::abs(way.z()) / size.z() * grid.rows);
    const int steps = 1 + int(std::ceil(2.0 * cells));
    for (int i = 0; i <= steps; ++i) {
        const double t = in + (out - in) * i / steps;
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

std::vector<ColliderBody> bodiesOf(const Scene& scene, std::vector<ColliderBody> before)
{
    std::vector<ColliderBody> bodies;
    for (const Entry& entry : scene.items) {
        const Collider* collider = std::get_if<Collider>(&entry.item);
        if (!collider)
            continue;
        const auto found = std::ranges::find(before, entry.id, &ColliderBody::id);
        const ColliderBody* known = found == before.end() ? nullptr : &*found;
        ColliderBody body = bodyOf(scene, entry.id, *collider, known);
        body.surface = known && looksAlike(*known, body) ? known->surface : surfaceOf(body);
        bodies.push_back(std::move(body));
    }
    return bodies;
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

std::vector<Vec3> cornersOf(const ColliderBody& body, const Vec3& place)
{
    std::vector<Vec3> corners;
    const Eigen::Matrix3d turn = turnAndScale(body.collider);
    if (!body.bounds.isEmpty())
        for (int i = 0; i < 8; ++i)
            corners.push_back(place
                              + turn * body.bounds.corner(Eigen::AlignedBox3d::CornerType(i)));
    return corners;
}

double distanceTo(const ColliderBody& body, const Vec3& place, const Vec3& origin,
                  const Vec3& direction)
{
    const Eigen::Matrix3d toOwn = turnAndScale(body.collider).inverse();
    const Vec3 from = toOwn * (origin - place);
    const Vec3 way = toOwn * direction;
    if (body.bounds.isEmpty())
        return never;
    if (body.collider.shape == ColliderShape::Sphere)
        return distanceToSphere(body.collider.radius, from, way);
    if (body.collider.shape == ColliderShape::Box)
        return within(body.bounds, from, way).in;
    if (body.grid)
        return distanceToGround(*body.grid, body.collider.size, body.bounds, from, way);
    if (!body.mesh)
        return never; // late
    const double far = (body.bounds.center() - from).norm() + body.bounds.diagonal().norm();
    const double length = far / way.norm(); // m in the scene
    const auto hit = body.mesh->firstHit(from, from + length * way);
    return hit ? hit->share * length : never;
}

} // namespace ripstop
