// Moves, turns and scales what is selected.
//
//     x' = pivot + M (x - pivot) + shift
//
// The rest lengths of links may stay, so that what is pulled apart is under load, or be bound anew
// to the distance between the ends, so that the design stays free of load.
#pragma once

#include "scene/edit.h"
#include "shaping/movable.h"

#include <Eigen/Geometry>

#include <array>
#include <string>

namespace ripstop {

enum class RestLengths { Keep, Rebind };

struct Motion
{
    Eigen::Affine3d map = Eigen::Affine3d::Identity(); // m to m
    bool rigid = true; // no distance changes between things that move together
};

Motion shifted(const Vec3& by);                                   // m
Motion turned(const Vec3& pivot, const Vec3& axis, double angle); // rad, axis not zero
Motion scaled(const Vec3& pivot, const Vec3& factors,
              const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity()); // above 0

// The collider after the motion, which may also be a mirroring.
Collider placed(const Collider& collider, const Motion& motion);

// Where a guide (laws/guide.h) points after the linear part of a motion.
Vec3 turnedAxis(Guide guide, const Vec3& axis, const Eigen::Matrix3d& linear);

// Sets the positions of the particles to places that are given one by one, [particles] m, and rest
// lengths when asked. Colliders stay.
Edit relocated(const Movable& movable, const std::vector<Vec3>& places, RestLengths restLengths,
               Message label);

// Sets positions, guides along, and, when asked, rest lengths: those of links between what moves
// and what stays, and of the links among what is scaled. The same properties of the same things for
// every motion of a kind, so that the steps of a gesture merge. Colliders go along: planes turn
// their normal, boxes, height fields and meshes their angles; spheres, turned boxes and meshes
// scale evenly, by the cube root of the change of volume. Empty when nothing moves.
Edit moved(const Movable& movable, const Motion& motion, RestLengths restLengths, Message label);

// "Move 12 particles and 1 collider", of Message("Move %1").
Message movingLabel(const Message& verb, const Movable& movable);

} // namespace ripstop
