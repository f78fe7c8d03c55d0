// update() sends a ray of the sun through each corner of the fabric to the ground that it meets
// first; a triangle has a shadow where all of its rays meet one.
#include "layers/shadow_layer.h"

#include "layers/backdrop_layer.h"
#include "look/collider_geometry.h"
#include "look/shadow_map.h"

#include <vtkRenderer.h>

#include <limits>

namespace ripstop {
namespace {

constexpr vtkIdType mostCorners = 20'000; // a larger sheet would cost too much of each picture
constexpr double missed = std::numeric_limits<double>::infinity(); // m, of what meets no ground

template <typename Visit> // visit(triangle)
void forEachTriangle(vtkPolyData& mesh, Visit visit)
{
    vtkNew<vtkIdList> triangle;
    for (vtkIdType i = 0; i < mesh.GetNumberOfCells(); ++i) {
        mesh.GetCellPoints(i, triangle);
        visit(*triangle);
    }
}

double meanSide(vtkPolyData& mesh) // m
{
    double sum = 0.0;
    forEachTriangle(mesh, [&](vtkIdList& triangle) {
        sum += (Vec3(mesh.GetPoint(triangle.GetId(1))) - Vec3(mesh.GetPoint(triangle.GetId(0))))
                   .norm();
    });
    return sum / std::max<double>(1.0, double(mesh.GetNumberOfCells()));
}

struct ShadowedGround
{
    const ColliderBody& body;
    Vec3 place; // m

    double wayTo(const Vec3& corner, const Vec3& ray) const // m along a ray of the sun
    {
        if (body.collider.shape != ColliderShape::Plane)
            return distanceTo(body, place, corner, ray);
        const Vec3& normal = body.collider.normal;
        const double way = (place - corner).dot(normal) / ray.dot(normal);
        return way >= 0.0 ? way : missed;
    }
};

// Landscapes, and planes that the sun lights where none of them is the ground of the backdrop.
std::vector<ShadowedGround> groundsOf(const Picture& picture)
{
    const bool hasSlopes = !levelPlane(picture.scene);
    std::vector<ShadowedGround> grounds;
    for (const ColliderBody& body : picture.colliders) {
        const Collider& collider = body.collider;
        const bool isSlope = hasSlopes && collider.shape == ColliderShape::Plane
                             && collider.normal.dot(sunDirection) > 0.0;
        if (collider.shown && (isSlope || isGround(body)))
            grounds.push_back({body, placeOf(picture.frame, body.id, collider)});
    }
    return grounds;
}

} // namespace

ShadowLayer::ShadowLayer(vtkPolyData& fabric)
    : m_fabric(fabric)
{
    m_points->SetDataTypeToDouble();
    m_mesh->SetPoints(m_points);
    m_mapper->SetInputData(m_mesh);
    m_mapper->ScalarVisibilityOff();
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.5, 6.0);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
}

void ShadowLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void ShadowLayer::setShown(bool shown)
{
    m_shown = shown;
    m_actor->SetVisibility(shown);
}

void ShadowLayer::rebuild(const Picture& picture)
{
    setColor(*m_actor->GetProperty(), picture.theme.shadow);
}

void ShadowLayer::update(const Picture& picture)
{
    const std::vector<ShadowedGround> grounds = groundsOf(picture);
    vtkPoints* const corners = m_fabric.GetPoints();
    const bool isDrawn = m_shown && !grounds.empty() && corners->GetNumberOfPoints() <= mostCorners;
    m_actor->SetVisibility(isDrawn);
    if (!isDrawn)
        return;

    // A triangle is flat where a landscape has bumps, which would come through: it lies over them
    // by half a side, but no more than half way up to the fabric.
    const Vec3 ray = -sunDirection.normalized();
    const double lift = 0.5 * meanSide(m_fabric);
    std::vector<std::uint8_t> meets(std::size_t(corners->GetNumberOfPoints()));
    m_points->SetNumberOfPoints(corners->GetNumberOfPoints());
    for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); ++i) {
        const Vec3 corner(corners->GetPoint(i));
        double way = missed, over = 0.0;
        for (const ShadowedGround& ground : grounds)
            if (const double own = ground.wayTo(corner, ray); own < way) {
                way = own;
                over = ground.body.collider.shape == ColliderShape::Plane ? 0.0 : lift;
            }
        meets[std::size_t(i)] = way < missed;
        const double shown = way < missed ? way - std::min(over, 0.5 * way) : 0.0;
        m_points->SetPoint(i, Vec3(corner + shown * ray).data());
    }
    vtkNew<vtkCellArray> triangles;
    forEachTriangle(m_fabric, [&](vtkIdList& triangle) {
        if (std::all_of(triangle.begin(), triangle.end(),
                        [&](vtkIdType corner) { return meets[std::size_t(corner)] != 0; }))
            triangles->InsertNextCell(&triangle);
    });
    m_mesh->SetPolys(triangles);
    m_points->Modified();
}

} // namespace ripstop
