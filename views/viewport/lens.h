// From the world to the picture and back: what lies under a pixel, and under which pixel a place
// lies. Pixels count from the top left of the picture.
#pragma once

#include "base/vec3.h"
#include "viewport/turntable.h"

#include <QPointF>

#include <optional>

namespace ripstop {

struct Ray
{
    Vec3 origin;    // m
    Vec3 direction; // unit
};

struct Lens
{
    Turntable camera;
    double width;  // pixels
    double height; // pixels

    Ray ray(double x, double y) const;
    Ray ray(QPointF place) const { return ray(place.x(), place.y()); }

    // Nothing for what lies behind the eye.
    std::optional<QPointF> pixel(const Vec3& place) const;

    double metresPerPixel(const Vec3& place) const; // at the depth of this place
    Vec3 towardsEye(const Vec3& place) const;       // unit
};

} // namespace ripstop
