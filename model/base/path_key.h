// A key of a collider's path: at this time it is at this place.
//
// Between two keys the collider moves straight and at constant speed; before the first and after
// the last it stays there (contact/obstacle_motion.cpp). The keys of a path stand in ascending
// order of time; scene/collider_path.h refuses others.
#pragma once

#include "base/vec3.h"

namespace ripstop {

struct PathKey
{
    double time = 0.0;         // s
    Vec3 place = Vec3::Zero(); // m

    friend bool operator==(const PathKey&, const PathKey&) = default;
};

} // namespace ripstop
