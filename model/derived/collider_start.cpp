#include "derived/collider_start.h"

#include "scene/collider_path.h"
#include "shapes/place_on_path.h"
#include "shapes/way_out.h"

namespace ripstop {
namespace {

ShapeData dataOf(const Scene& scene, const Collider& collider)
{
    auto data = shapeDataOf(scene, collider);
    return data ? std::move(*data) : ShapeData();
}

Vec3 placeAtStart(const Collider& collider)
{
    const auto path = pathFromText(collider.path);
    return path && !path->empty() ? placeOnPath(*path, 0.0) : collider.position;
}

} // namespace

ColliderStart::ColliderStart(const Scene& scene, const Collider& collider)
    : m_shape(collider.shape)
    , m_data(dataOf(scene, collider))
    , m_solid(solidOf(collider, m_data))
    , m_turn(rowOf(m_shape).uses.turn ? turnOf(collider) : Eigen::Matrix3d::Identity())
    , m_box(rowOf(m_shape).bounds(m_solid))
    , m_position(placeAtStart(collider))
    , m_isSound(!colliderError(scene, collider))
{
    m_solid.normal.normalize();
    if (m_box.isEmpty())
        return;
    const Vec3 margin = Vec3::Constant(m_solid.margin);
    m_box.extend(Vec3(m_box.min() - margin));
    m_box.extend(Vec3(m_box.max() + margin));
}

std::optional<Touch> ColliderStart::wayOut(const Vec3& place) const
{
    if (!m_isSound)
        return std::nullopt;
    const Vec3 own = m_turn.transpose() * (place - m_position);
    if (!m_box.isEmpty() && !m_box.contains(own))
        return std::nullopt;
    const auto touch = ripstop::wayOut(m_shape, m_solid, own);
    if (!touch)
        return std::nullopt;
    return Touch{m_position + m_turn * touch->surface, m_turn * touch->normal};
}

} // namespace ripstop
