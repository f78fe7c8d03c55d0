// The plane that a part is most nearly its own mirror image at: what "the other side" means for a
// kite, whose halves lie along z, as for a sail that was drawn along x.
//
// The plane stands across an axis of the world, in the middle between the outermost particles of
// the fabric. Of the axes along which fabric reaches, that is taken along which it is spread most
// evenly to both sides: odd moments of what is symmetric are zero. Where two are alike, as of a
// round canopy, z comes before x and x before y.
#pragma once

#include "scene/scene.h"

namespace ripstop {

struct MirrorPlane
{
    int axis = 0;    // 0 to 2
    double at = 0.0; // m, along it

    Vec3 mirrored(Vec3 place) const
    {
        place[axis] = 2.0 * at - place[axis];
        return place;
    }
};

// Of what panels join, or of all particles where there are no panels.
MirrorPlane mirrorPlaneOf(const Part& part);

// The part that has a particle nearest to this place, m; noId where there are none.
Id partNearest(const Scene& scene, const Vec3& place);

} // namespace ripstop
