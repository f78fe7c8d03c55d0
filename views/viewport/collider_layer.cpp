#include "viewport/collider_layer.h"

#include "viewport/collider_geometry.h"

#include <vtkRenderer.h>

namespace ripstop {

void ColliderLayer::setShown(bool shown)
{
    m_shown = shown;
    for (const Drawn& drawn : m_drawn)
        drawn.actor->SetVisibility(shown);
}

void ColliderLayer::rebuild(const Picture& picture)
{
    for (const Drawn& drawn : m_drawn)
        m_renderer->RemoveActor(drawn.actor);
    m_drawn.clear();
    for (const Entry& entry : picture.scene.items) {
        const Collider* collider = std::get_if<Collider>(&entry.item);
        if (!collider || !collider->shown || collider->shape == ColliderShape::Plane)
            continue;
        Drawn drawn{entry.id, {}, {}};
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(surfaceOf(picture.scene, *collider));
        // fabric that lies on a flat face is seen before it
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 16.0);
        drawn.actor->SetMapper(mapper);
        drawn.actor->SetUserMatrix(drawn.matrix);
        const bool isSelected = std::ranges::binary_search(picture.selected, entry.id);
        const bool isGround = collider->shape == ColliderShape::HeightField;
        vtkProperty& property = *drawn.actor->GetProperty();
        setColor(property, isSelected ? picture.theme.accent
                           : isGround ? picture.theme.ground
                                      : picture.theme.neutral);
        property.SetInterpolationToPhong();
        property.SetAmbient(0.25);
        property.SetDiffuse(0.75);
        property.SetSpecular(isGround ? 0.0 : 0.15);
        property.SetSpecularPower(30.0);
        m_renderer->AddActor(drawn.actor);
        m_drawn.push_back(std::move(drawn));
    }
    setShown(m_shown);
}

void ColliderLayer::update(const Picture& picture)
{
    for (const Drawn& drawn : m_drawn) {
        const Collider* collider = findItem<Collider>(picture.scene, drawn.collider);
        if (!collider)
            continue;
        const Eigen::Matrix3d turn = turnAndScale(*collider);
        const Vec3 place = placeOf(picture.frame, drawn.collider, *collider);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                drawn.matrix->SetElement(row, column, turn(row, column));
            drawn.matrix->SetElement(row, 3, place[row]);
        }
    }
}

} // namespace ripstop
