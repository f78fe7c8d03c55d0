// add() puts the rings of a limb about its axis, from pole to pole: quarter circles at both ends
// with the wall between them. Normals point away from the axis as those of a sphere do at the ends;
// the slight slope of the wall is left out of them.
#include "layers/person_layer.h"

#include "look/figure.h"

#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr int sides = 14;
constexpr int ringsPerEnd = 5;

} // namespace

PersonLayer::PersonLayer()
{
    m_points->SetDataTypeToDouble();
    m_normals->SetNumberOfComponents(3);
    m_data->SetPoints(m_points);
    m_data->SetPolys(m_cells);
    m_data->GetPointData()->SetNormals(m_normals);
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_actor->SetMapper(m_mapper);
    vtkProperty& property = *m_actor->GetProperty();
    property.SetInterpolationToPhong();
    property.SetAmbient(0.42);
    property.SetDiffuse(0.68);
    property.SetSpecular(0.06);
}

void PersonLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void PersonLayer::rebuild(const Picture& picture)
{
    setColor(*m_actor->GetProperty(), picture.theme.person);
}

void PersonLayer::add(const Limb& limb)
{
    const auto& [along, across, third] = LimbAxes(limb);
    const vtkIdType first = m_points->GetNumberOfPoints();
    for (int ring = 0; ring < 2 * ringsPerEnd; ++ring) {
        const bool isNear = ring < ringsPerEnd;
        const Vec3& middle = isNear ? limb.from : limb.to;
        const double radius = isNear ? limb.fromRadius : limb.toRadius;
        const double share = double(isNear ? ring : ring - ringsPerEnd) / (ringsPerEnd - 1);
        const double tilt = 0.5 * std::numbers::pi * (isNear ? share - 1.0 : share);
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            const Vec3 normal =
                std::sin(tilt) * along
                + std::cos(tilt) * (std::cos(angle) * across + std::sin(angle) * third);
            m_points->InsertNextPoint(Vec3(middle + radius * normal).data());
            m_normals->InsertNextTuple(normal.data());
        }
    }
    for (int ring = 0; ring + 1 < 2 * ringsPerEnd; ++ring)
        for (int side = 0; side < sides; ++side) {
            const vtkIdType here = first + ring * sides + side;
            const vtkIdType next = first + ring * sides + (side + 1) % sides;
            m_cells->InsertNextCell({here, next, next + sides, here + sides});
        }
}

void PersonLayer::update(const Picture& picture)
{
    m_points->Reset();
    m_normals->Reset();
    m_cells->Reset();
    for (const std::vector<Limb>& body : picture.limbs)
        for (const Limb& limb : body)
            add(limb);
    m_points->Modified();
    m_normals->Modified();
    m_cells->Modified();
    m_data->Modified();
}

} // namespace ripstop
