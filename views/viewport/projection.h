// Where places of the world lie in the picture.
#pragma once

#include "viewport/tool.h"

#include <limits>

namespace ripstop {

struct OnScreen
{
    double x;     // pixels, from the left
    double y;     // pixels, from the top
    double depth; // m in front of the eye, along the view; infinite behind a perspective eye

    bool isSeen() const { return depth < std::numeric_limits<double>::infinity(); }
};

class Projection
{
public:
    explicit Projection(const Sight& sight);
    Projection(const Turntable& camera, double width, double height); // pixels

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

private:
    Turntable m_camera;
    Vec3 m_eye, m_right, m_up, m_back;
    double m_width, m_height; // pixels
    double m_scale;           // pixels per m at depth 1, or per m where there is no perspective
};

} // namespace ripstop
