// Where places of the world lie in the picture, and which places a pixel can be of.
//
// A projection is a camera and the size of a picture; it holds copies of both, so that it can be
// kept for as long as a gesture lasts. Pixels count from the top left.
#pragma once

#include "camera/camera_view.h"

#include <QPointF>

#include <limits>
#include <optional>

namespace ripstop {

struct OnScreen
{
    double x;     // pixels, from the left
    double y;     // pixels, from the top
    double depth; // m in front of the eye, along the view; infinite behind a perspective eye

    bool isSeen() const { return depth < std::numeric_limits<double>::infinity(); }
};

class CameraProjection
{
public:
    explicit CameraProjection(const CameraView& view);
    CameraProjection(const Camera& camera, double width, double height); // pixels

    OnScreen operator()(const Vec3& place) const;

    // m in front of the eye, along the view; negative behind it.
    double depthOf(const Vec3& place) const { return (m_eye - place).dot(m_back); }

    // The ray that runs through a place of the picture: its origin is the eye, or far in front of
    // the picture where the view has no perspective.
    struct Ray
    {
        Vec3 origin;    // m
        Vec3 direction; // unit
    };
    Ray rayThrough(const Vec3& place) const;
    Ray rayAt(double x, double y) const; // pixels
    Ray rayAt(QPointF pixel) const { return rayAt(pixel.x(), pixel.y()); }

    // The pixel of a place; nothing for a place behind the eye.
    std::optional<QPointF> pixel(const Vec3& place) const;

    double metresPerPixel(const Vec3& place) const; // at the depth of this place
    Vec3 towardsEye(const Vec3& place) const;       // unit

    const Camera& camera() const { return m_camera; }

private:
    Camera m_camera;
    Vec3 m_eye, m_right, m_up, m_back;
    double m_width, m_height; // pixels
    double m_scale;           // pixels per m at depth 1, or per m where there is no perspective
};

} // namespace ripstop
