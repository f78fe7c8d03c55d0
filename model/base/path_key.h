#pragma once

#include "base/vec3.h"

namespace ripstop {

// A thing that moves along a path is at this place at this time, and on a straight line between.
struct PathKey
{
    double time = 0.0;         // s
    Vec3 place = Vec3::Zero(); // m

    friend bool operator==(const PathKey&, const PathKey&) = default;
};

} // namespace ripstop
