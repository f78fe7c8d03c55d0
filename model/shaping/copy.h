// Copies of what is selected: beside it, in rows and rings, mirrored, or in another scene.
//
// Elements mean the particles that they touch (see movable.h), with the links and panels that lie
// among them. Their copies go into the same part; a part that is selected as such is copied as a
// part. Colliders, winds, groups, controls and probes are copied when they are selected themselves,
// and refer to the copies of what they referred to. Copies get ids of their own.
#pragma once

#include "base/result.h"
#include "shaping/transform.h"

namespace ripstop {

struct Copies
{
    Edit edit;
    std::vector<Id> ids; // what was made, ascending: the items, and elements that have no new item
};

// One copy for each motion, at the place where that takes the original.
Copies duplicated(const Scene& scene, const std::vector<Id>& ids,
                  const std::vector<Motion>& motions, Message label);

// `count` things in all, with the original: each a step further than the one before.
Copies linearArray(const Scene& scene, const std::vector<Id>& ids, int count, const Vec3& step);

// `count` things in all, over `angle` rad about the axis; a full turn leaves out the last, which
// would lie on the first.
Copies radialArray(const Scene& scene, const std::vector<Id>& ids, int count, const Vec3& pivot,
                   const Vec3& axis, double angle);

// The other half: mirrored at the plane through `point`. Particles within `tolerance` m of the
// plane are put on it and belong to both halves, so that the halves hang together; they keep their
// mass. Panels are turned round, so that they face outwards as the originals do; copies join the
// groups of their originals.
Copies mirrored(const Scene& scene, const std::vector<Id>& ids, const Vec3& point, int axis,
                double tolerance);

// What is selected as a scene of its own, with the materials that it needs: for the clipboard.
Scene excerpt(const Scene& scene, const std::vector<Id>& ids);

// All that is in `fragment`. Materials that the scene has already are used again.
Copies pasted(const Scene& scene, const Scene& fragment);

} // namespace ripstop
