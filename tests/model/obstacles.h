// Obstacles of the tests of contact: bodies with the response contact, without restitution, that
// stand upright around the origin unless a test turns or moves them. Lengths are in m.
#pragma once

#include "system/obstacle.h"

#include <cmath>

namespace ripstop {

inline Obstacle obstacle(ColliderShape shape, const Vec3& position = Vec3::Zero(),
                         double friction = 0.0)
{
    Obstacle result{shape, position, {0.0, 1.0, 0.0}, 0.5, Response::Contact, 0.0, friction};
    return result;
}

// Its axis along y before it is turned.
inline Obstacle cylinder(double radius, double height, const Vec3& position = Vec3::Zero(),
                         double friction = 0.0)
{
    Obstacle result = obstacle(ColliderShape::Cylinder, position, friction);
    result.radius = radius;
    result.size = Vec3(1.0, height, 1.0);
    return result;
}

// Lies along x, and climbs towards +x by this angle, rad.
inline Obstacle lyingCylinder(double radius, double length, double angle, double friction = 0.0)
{
    Obstacle result = cylinder(radius, length, Vec3::Zero(), friction);
    const double c = std::cos(angle), s = std::sin(angle);
    result.turn.col(0) = Vec3(-s, c, 0.0);
    result.turn.col(1) = Vec3(c, s, 0.0);
    result.turn.col(2) = -Vec3::UnitZ();
    return result;
}

} // namespace ripstop
