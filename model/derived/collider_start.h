// A collider where it is when a run starts, to be asked about places of the scene. Its files are
// read once, on making it; any thread may ask.
#pragma once

#include "derived/collider_shape.h"

#include <Eigen/Core>

#include <optional>

namespace ripstop {

class ColliderStart
{
public:
    ColliderStart(const Scene& scene, const Collider& collider);

    // Where contact puts what begins at `place`, m; nothing when it leaves it there. A collider
    // whose file or path is no good touches nothing.
    std::optional<Touch> wayOut(const Vec3& place) const;

private:
    ColliderShape m_shape;
    ShapeData m_data; // of m_solid
    Solid m_solid;
    Eigen::Matrix3d m_turn;
    Eigen::AlignedBox3d m_box; // with its margin, in its own frame; empty where it has no end
    Vec3 m_position;           // m
    bool m_isSound;
};

} // namespace ripstop
