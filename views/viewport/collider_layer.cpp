#include "viewport/collider_layer.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

// A panel that rests on a sphere with its corners dips into it with its middle; drawn a little
// smaller, the sphere does not show through.
constexpr double drawnSize = 0.965;

} // namespace

ColliderLayer::ColliderLayer()
{
    m_sphere->SetRadius(1.0);
    m_sphere->SetThetaResolution(72);
    m_sphere->SetPhiResolution(48);
    m_mapper->SetInputConnection(m_sphere->GetOutputPort());
}

void ColliderLayer::setShown(bool shown)
{
    m_shown = shown;
    for (const auto& actor : m_actors)
        actor->SetVisibility(shown);
}

void ColliderLayer::rebuild(const Picture& picture)
{
    for (const auto& actor : m_actors)
        m_renderer->RemoveActor(actor);
    m_actors.clear();
    for (const Entry& entry : picture.scene.items) {
        const Collider* collider = std::get_if<Collider>(&entry.item);
        if (!collider || !collider->shown || collider->shape != ColliderShape::Sphere)
            continue;
        vtkNew<vtkActor> actor;
        actor->SetMapper(m_mapper);
        actor->SetPosition(collider->position.x(), collider->position.y(), collider->position.z());
        actor->SetScale(drawnSize * collider->radius);
        const bool isSelected = std::ranges::binary_search(picture.selected, entry.id);
        vtkProperty& property = *actor->GetProperty();
        setColor(property, isSelected ? picture.theme.accent : picture.theme.neutral);
        property.SetInterpolationToPhong();
        property.SetAmbient(0.25);
        property.SetDiffuse(0.75);
        property.SetSpecular(0.15);
        property.SetSpecularPower(30.0);
        m_renderer->AddActor(actor);
        m_actors.push_back(std::move(actor));
    }
    setShown(m_shown);
}

} // namespace ripstop
