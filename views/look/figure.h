// The body of a person in a frame, as limbs with round ends.
//
// Lengths of segments are shares of a height of 1.75 m after Drillis and Contini 1966, as the usual
// table of anthropometry has them: hips 0.530, knees 0.285, shoulders 0.818, chin 0.870, upper arm
// 0.186, forearm and half a hand 0.200. Who holds something low goes down on their knees for it;
// what is out of reach has nobody.
#pragma once

#include "look/collider_geometry.h"
#include "look/people.h"

#include <vector>

namespace ripstop {

inline constexpr double personHeight = 1.75; // m

// A cone with round ends.
struct Limb
{
    Vec3 from, to;               // m
    double fromRadius, toRadius; // m
};

// The way of a limb, which may have no length, and two directions across it; 1 long each.
struct LimbAxes
{
    Vec3 along, across, third;
    explicit LimbAxes(const Limb& limb);
};

// Empty when there is nobody: what they hold is out of reach, or not a place.
std::vector<Limb> limbsOf(const Person& person, const Frame& frame,
                          const std::vector<ColliderBody>& colliders);

} // namespace ripstop
