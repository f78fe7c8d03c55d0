// The axes of the picture follow from azimuth and elevation alone, and all else from these axes.
//
// Movements: orbit() turns about the focus, pan() shifts it in the plane of the picture, zoom()
// shifts it so that the place under the cursor stays.
//
// fit() looks along each axis of the picture for the nearest eye whose two lines of sight leave all
// points between them (Wedge); of width and height the one that needs more room decides.
//
// projection() is the matrix of the view times that of the lens.
#include "camera/camera.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radiansPerPixel = 0.0075;
constexpr double margin = 1.12;  // around what fits
constexpr double nearest = 1e-3; // m
constexpr double farthest = 1e6; // m

double tangent() { return std::tan(0.5 * Camera::viewAngle); }

// One axis of the picture: points between two lines of sight that part from the eye.
struct Wedge
{
    double low, high; // their slopes, m of width per m of depth, to either side
    double lower = -1e300, upper = -1e300;

    void add(double place, double depth) // m, depth towards the eye
    {
        lower = std::max(lower, low * depth - place);
        upper = std::max(upper, high * depth + place);
    }
    double leastDepth() const { return (lower + upper) / (low + high); } // of the eye
    double middle(double depth) const // where the eye sees as much free room on both sides
    {
        return 0.5 * (upper - high * depth + low * depth - lower);
    }
};

} // namespace

Vec3 Camera::back() const
{
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

// Well defined also when looking straight down, which a cross product with y is not.
Vec3 Camera::right() const { return {std::cos(azimuth), 0.0, -std::sin(azimuth)}; }

Vec3 Camera::up() const { return back().cross(right()); }

double Camera::halfHeight() const { return distance * tangent(); }

void Camera::orbit(double dx, double dy)
{
    azimuth = std::remainder(azimuth - radiansPerPixel * dx, 2.0 * pi);
    elevation = std::clamp(elevation + radiansPerPixel * dy, -0.5 * pi, 0.5 * pi);
}

void Camera::pan(double dx, double dy, double pictureHeight)
{
    const double metresPerPixel = 2.0 * halfHeight() / std::max(1.0, pictureHeight);
    focus += metresPerPixel * (dy * up() - dx * right());
}

void Camera::zoom(double factor, double x, double y, double aspect)
{
    const double before = halfHeight();
    distance = std::clamp(distance * factor, nearest, farthest);
    const double change = before - halfHeight();
    focus += change * (x * aspect * right() + y * up());
}

void Camera::liftEye(double height)
{
    const double rise = (height - focus.y()) / distance;
    if (rise > std::sin(elevation))
        elevation = std::asin(std::min(rise, 1.0));
}

void Camera::look(PresetView view)
{
    const auto turn = [this](double azimuthDegrees, double elevationDegrees) {
        azimuth = azimuthDegrees * pi / 180.0;
        elevation = elevationDegrees * pi / 180.0;
    };
    switch (view) {
    case PresetView::Front:
        return turn(0, 0);
    case PresetView::Back:
        return turn(180, 0);
    case PresetView::Left:
        return turn(-90, 0);
    case PresetView::Right:
        return turn(90, 0);
    case PresetView::Top:
        return turn(0, 90);
    case PresetView::Bottom:
        return turn(0, -90);
    case PresetView::Iso:
        return turn(35, 12); // low enough for the horizon to be in the picture
    }
}

// Each side of the view pyramid must leave all points inside: with t the slope of the side,
// |x - centre| <= t (eye - z). The outermost points for the two sides give centre and eye.
void Camera::fit(std::span<const Vec3> points, double aspect, const OverlayMargins& margins)
{
    if (points.empty())
        return;
    const Vec3 axisX = right(), axisY = up(), axisZ = back();
    const double slopeY = tangent() / margin, slopeX = slopeY * aspect;
    Wedge across{slopeX * (1.0 - 2.0 * margins.left), slopeX * (1.0 - 2.0 * margins.right)};
    Wedge upright{slopeY * (1.0 - 2.0 * margins.bottom), slopeY * (1.0 - 2.0 * margins.top)};

    Eigen::AlignedBox3d box; // along the axes of the picture
    for (const Vec3& point : points) {
        const Vec3 place(point.dot(axisX), point.dot(axisY), point.dot(axisZ));
        box.extend(place);
        across.add(place.x(), orthographic ? 0.0 : place.z());
        upright.add(place.y(), orthographic ? 0.0 : place.z());
    }
    const double middle = box.center().z();
    const double eye = std::max(across.leastDepth(), upright.leastDepth());
    distance = std::max(orthographic ? eye : eye - middle, nearest);
    if (box.sizes().isZero(0.0))
        distance = 1.0; // a single particle
    const double depth = orthographic ? distance : distance + middle;
    focus = across.middle(depth) * axisX + upright.middle(depth) * axisY + middle * axisZ;
}

Eigen::Matrix4d Camera::projection(double aspect) const
{
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = right().transpose();
    view.block<1, 3>(1, 0) = up().transpose();
    view.block<1, 3>(2, 0) = back().transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye();

    const double scale = orthographic ? 1.0 / halfHeight() : 1.0 / tangent();
    Eigen::Matrix4d lens = Eigen::Matrix4d::Zero();
    lens(0, 0) = scale / aspect;
    lens(1, 1) = scale;
    lens(2, 2) = -1.0; // depth, m; VTK makes its own for the depth buffer
    if (orthographic)
        lens(3, 3) = 1.0;
    else
        lens(3, 2) = -1.0;
    return lens * view;
}

} // namespace ripstop
