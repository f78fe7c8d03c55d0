// bodiesOf() walks over the colliders of the scene: it takes the data of each shape as far as
// another thread has read or made them (Effort::None, so that the window never waits for a file),
// and makes a surface only where shape, size or data differ from those of the body before.
//
// A surface is the mesh that the row of the shape gives, made into VTK cells; where the shape has
// no normals of its own, VTK finds them and keeps sharp edges.
//
// The other functions turn between the frame of the body and the scene: points go one way, rays the
// other.
#include "look/collider_geometry.h"

#include "derived/collider_shape.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

// Where the shape has no normals of its own, faces that meet at more than this have an edge.
constexpr double edgeAngle = 40.0; // degrees

constexpr double flattest = 0.1; // of the normal of a plane that one can stand on, upwards
constexpr double headroom = 0.5; // m, that ground may lie above what stands on it

// The shape in its own frame, and a mesh in its own units, so that a collider that only grows keeps
// its surface.
Solid solidOf(const ColliderBody& body)
{
    Solid solid = solidOf(body.collider, {body.grid, body.mesh});
    solid.scale = 1.0;
    return solid;
}

vtkSmartPointer<vtkPolyData> surfaceOf(const ShapeSurface& surface)
{
    if (surface.faces.empty())
        return nullptr;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const Vec3& point : surface.points)
        points->InsertNextPoint(point.data());
    for (const auto& [a, b, c, d] : surface.faces) {
        const std::array<vtkIdType, 4> corners{a, b, c, d};
        cells->InsertNextCell(d < 0 ? 3 : 4, corners.data());
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    if (!surface.normals.empty()) {
        vtkNew<vtkDoubleArray> normals;
        normals->SetNumberOfComponents(3);
        for (const Vec3& normal : surface.normals)
            normals->InsertNextTuple(normal.data());
        data->GetPointData()->SetNormals(normals);
        return data;
    }
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(data);
    normals->SetFeatureAngle(edgeAngle);
    normals->Update();
    return normals->GetOutput();
}

ColliderBody bodyOf(const Scene& scene, Id id, const Collider& collider, const ColliderBody* before)
{
    ColliderBody body;
    body.id = id;
    body.collider = collider;
    const ShapeRow& row = rowOf(collider.shape);
    const auto data = shapeDataOf(scene, collider, Effort::None);
    if (!data)
        return body; // nothing can be made of its file
    body.isLate = row.madeOf != MadeOf::Numbers && !data->grid && !data->mesh;
    const bool isKept = body.isLate && before;
    body.grid = isKept ? before->grid : data->grid;
    body.mesh = isKept ? before->mesh : data->mesh;
    body.bounds = row.bounds(solidOf(body));
    return body;
}

bool looksAlike(const ColliderBody& a, const ColliderBody& b)
{
    return a.collider.shape == b.collider.shape && a.collider.radius == b.collider.radius
           && a.collider.size == b.collider.size && a.grid == b.grid && a.mesh == b.mesh;
}

vtkSmartPointer<vtkPolyData> surfaceOf(const ColliderBody& body)
{
    if (body.bounds.isEmpty())
        return nullptr;
    return surfaceOf(rowOf(body.collider.shape).surface(solidOf(body)));
}

// Brings points from the frame of a body into the scene.
std::vector<Vec3> inScene(const ColliderBody& body, const Vec3& place, std::vector<Vec3> points)
{
    const Eigen::Matrix3d turn = turnAndScale(body.collider);
    for (Vec3& point : points)
        point = place + turn * point;
    return points;
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
    const ShapeUses& uses = rowOf(collider.shape).uses;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (uses.turn)
        turn = turnOf(collider);
    if (uses.scale)
        turn *= collider.scale;
    return turn;
}

bool isGround(const ColliderBody& body) { return rowOf(body.collider.shape).isGround; }

std::vector<Vec3> cornersOf(const ColliderBody& body, const Vec3& place)
{
    std::vector<Vec3> corners;
    if (!body.bounds.isEmpty())
        for (int i = 0; i < 8; ++i)
            corners.push_back(body.bounds.corner(Eigen::AlignedBox3d::CornerType(i)));
    return inScene(body, place, std::move(corners));
}

std::vector<Vec3> extremesOf(const ColliderBody& body, const Vec3& place)
{
    if (body.bounds.isEmpty())
        return {};
    return inScene(body, place, rowOf(body.collider.shape).extremes(solidOf(body)));
}

double distanceTo(const ColliderBody& body, const Vec3& place, const Vec3& origin,
                  const Vec3& direction)
{
    if (body.bounds.isEmpty())
        return noHit;
    const Eigen::Matrix3d toOwn = turnAndScale(body.collider).inverse();
    const ShapeRay ray{toOwn * (origin - place), toOwn * direction};
    return rowOf(body.collider.shape).ray(solidOf(body), ray);
}

double groundBelow(const std::vector<ColliderBody>& bodies, const Frame& frame, const Vec3& place)
{
    double highest = -noHit;
    for (const ColliderBody& body : bodies) {
        const Collider& collider = body.collider;
        const Vec3 middle = placeOf(frame, body.id, collider);
        const Vec3 normal = collider.normal.normalized();
        double height = -noHit;
        if (collider.shape == ColliderShape::Plane && normal.y() > flattest)
            height = place.y() - (place - middle).dot(normal) / normal.y();
        else if (isGround(body))
            height = place.y() + headroom
                     - distanceTo(body, middle, place + headroom * Vec3::UnitY(), -Vec3::UnitY());
        if (collider.shown && height <= place.y() + headroom)
            highest = std::max(highest, height);
    }
    return highest;
}

} // namespace ripstop
