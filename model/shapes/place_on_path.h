// Where a path has its collider at a time. Contact asks it at each substep, the check of a scene
// about the start.
#pragma once

#include "base/path_key.h"

#include <algorithm>
#include <vector>

namespace ripstop {

// m; the path has at least one key, and its times ascend.
inline Vec3 placeOnPath(const std::vector<PathKey>& path, double time)
{
    const auto next = std::upper_bound(path.begin(), path.end(), time,
                                       [](double t, const PathKey& key) { return t < key.time; });
    if (next == path.begin())
        return path.front().place;
    const PathKey& last = *(next - 1);
    if (next == path.end())
        return last.place;
    const double share = (time - last.time) / (next->time - last.time);
    return last.place + share * (next->place - last.place);
}

} // namespace ripstop
