#include "layers/shadow_layer.h"

#include "layers/backdrop_layer.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

// The plane that the sun throws a hard shadow on; none where a level one has a soft one.
const Collider* slope(const Scene& scene)
{
    if (levelPlane(scene))
        return nullptr;
    for (const Entry& entry : scene.items)
        if (const Collider* plane = std::get_if<Collider>(&entry.item);
            plane && plane->shown && plane->shape == ColliderShape::Plane
            && plane->normal.dot(sunDirection) > 0.0)
            return plane;
    return nullptr;
}

} // namespace

ShadowLayer::ShadowLayer(vtkPolyData& fabric)
{
    m_mapper->SetInputData(&fabric);
    m_mapper->ScalarVisibilityOff();
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.5, 6.0);
    m_actor->SetMapper(m_mapper);
    m_actor->SetUserMatrix(m_projection);
    m_actor->GetProperty()->LightingOff();
}

void ShadowLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void ShadowLayer::setShown(bool shown)
{
    m_shown = shown;
    m_actor->SetVisibility(m_shown && m_hasGround);
}

void ShadowLayer::rebuild(const Picture& picture)
{
    setColor(*m_actor->GetProperty(), picture.theme.shadow);
    const Collider* const plane = slope(picture.scene);
    m_hasGround = plane != nullptr;
    if (plane) {
        // p - s (n . (p - p0)) / (n . s): along the sun's rays s onto the plane
        const Vec3 weight = plane->normal / plane->normal.dot(sunDirection);
        const Eigen::Matrix3d linear =
            Eigen::Matrix3d::Identity() - sunDirection * weight.transpose();
        const Vec3 shift = sunDirection * weight.dot(plane->position);
        m_projection->Identity();
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                m_projection->SetElement(row, column, linear(row, column));
            m_projection->SetElement(row, 3, shift[row]);
        }
    }
    setShown(m_shown);
}

} // namespace ripstop
