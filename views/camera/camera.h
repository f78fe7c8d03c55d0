// The camera: it turns about a point like a turntable, so that the horizon stays level.
//
// Azimuth turns it about the vertical, elevation lifts it; there is no roll, y is always up in
// the picture. The field of view is that of a standard lens; an orthographic camera keeps the
// same distance and shows as much as the perspective one does at the focus.
#pragma once

#include "base/vec3.h"

#include <Eigen/Core>

#include <span>

namespace ripstop {

// What of the picture is covered, by tools and legends: shares of its width and height.
struct OverlayMargins
{
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;
};

enum class PresetView { Front, Back, Left, Right, Top, Bottom, Iso };

class Camera
{
public:
    static constexpr double viewAngle =
        0.6109; // rad, 35 degrees, from bottom to top of the picture

    Vec3 focus = Vec3::Zero(); // m, what it turns about
    double distance = 10.0;    // m, from the focus to the eye
    double azimuth = 0.0;      // rad, 0 looks along -z, positive turns the eye towards +x
    double elevation = 0.0;    // rad, -pi/2 .. pi/2
    bool orthographic = false;

    // Axes of the picture in the world, unit.
    Vec3 right() const;
    Vec3 up() const;
    Vec3 back() const; // from the focus towards the eye

    Vec3 eye() const { return focus + distance * back(); }
    double halfHeight() const; // m, half of what the picture shows at the focus

    // Mouse movements in pixels, y down, in a picture of that size.
    void orbit(double dx, double dy);
    void pan(double dx, double dy, double pictureHeight);

    // Below 1 moves in. The point under the cursor stays where it is; `x` and `y` are its place
    // in the picture from -1 to 1, right and up.
    void zoom(double factor, double x, double y, double aspect);

    void look(PresetView view);

    // Turns about the focus until the eye is at least that high, m, as far as that goes.
    void liftEye(double height);

    // Moves so that all points just fit into what is not covered, with a margin. `aspect` is width
    // over height.
    void fit(std::span<const Vec3> points, double aspect, const OverlayMargins& margins = {});

    // From the world to the picture: after division by w, x and y lie in -1 .. 1 inside the
    // picture, and w is the depth in front of the eye, m (1 when orthographic).
    Eigen::Matrix4d projection(double aspect) const;
};

} // namespace ripstop
