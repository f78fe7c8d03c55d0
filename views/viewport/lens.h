// The camera and the size of the picture: what a gizmo needs to know of the view. Pixels count from
// the top left.
#pragma once

#include "viewport/projection.h"

#include <QPointF>

#include <optional>

namespace ripstop {

struct Lens
{
    Turntable camera;
    double width;  // pixels
    double height; // pixels

    Projection::Ray ray(QPointF place) const;

    // Nothing for what lies behind the eye.
    std::optional<QPointF> pixel(const Vec3& place) const;

    double metresPerPixel(const Vec3& place) const; // at the depth of this place
    Vec3 towardsEye(const Vec3& place) const;       // unit
};

} // namespace ripstop
