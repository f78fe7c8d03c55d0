// Boxes and spheres: where a way enters them, the nearest place to a point, and the touch made of
// both. A point whose way enters is put onto the face that it came through, however deep it is;
// otherwise a point within the margin goes to the nearest place. A sphere takes the nearest place
// for light touches too, so that fabric slides around it.
#include "shapes/round_shapes.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// The normal of the face through which the way enters the box, or nothing. A start on a face
// counts as outside of it.
std::optional<Vec3> faceEntered(const Vec3& half, const Vec3& from, const Vec3& to)
{
    const double slack = onSurface * half.maxCoeff();
    double entry = -1.0; // share of the way
    int face = -1;
    for (int i = 0; i < 3; ++i) {
        const double side = from[i] < 0.0 ? -1.0 : 1.0;
        const double gap = side * from[i] - half[i];
        if (gap < -slack)
            continue;
        const double inwards = side * (from[i] - to[i]);
        if (inwards <= gap || inwards <= 0.0)
            return std::nullopt;
        const double share = gap > 0.0 ? gap / inwards : 0.0;
        if (share > entry) {
            entry = share;
            face = i;
        }
    }
    if (face < 0)
        return std::nullopt;
    const Vec3 place = from + entry * (to - from);
    for (int i = 0; i < 3; ++i)
        if (i != face && std::abs(place[i]) > half[i] + slack)
            return std::nullopt;
    return Vec3((from[face] < 0.0 ? -1.0 : 1.0) * Vec3::Unit(face));
}

// The normal where the way of a point that starts outside enters the sphere, or nothing.
std::optional<Vec3> entered(double radius, const Vec3& from, const Vec3& to)
{
    const Vec3 way = to - from;
    const double squared = way.squaredNorm();
    const double along = -from.dot(way); // squared x (share of the way where it is nearest)
    const double root = along * along - squared * (from.squaredNorm() - radius * radius);
    if (along <= 0.0 || root <= 0.0)
        return std::nullopt;
    const double entry = std::max(0.0, along - std::sqrt(root));
    if (entry > squared)
        return std::nullopt;
    return (from + entry / squared * way).normalized();
}

} // namespace

Nearest nearestOnBox(const Vec3& half, const Vec3& point)
{
    const Vec3 beyond = point.cwiseAbs() - half;
    const Vec3 outside = beyond.cwiseMax(0.0);
    Vec3 side;
    for (int i = 0; i < 3; ++i)
        side[i] = point[i] < 0.0 ? -1.0 : 1.0;
    if (const double distance = outside.norm(); distance > 0.0)
        return {distance, outside.cwiseProduct(side) / distance};
    Eigen::Index axis = 0;
    const double depth = beyond.maxCoeff(&axis);
    return {depth, side[axis] * Vec3::Unit(axis)};
}

Nearest nearestOnSphere(double radius, const Vec3& point)
{
    const double distance = point.norm();
    // At the very centre every way out is equally short.
    return {distance - radius, distance > 0.0 ? Vec3(point / distance) : Vec3(0.0, 1.0, 0.0)};
}

std::optional<Touch> touchBox(const Vec3& half, double margin, const Vec3& from, const Vec3& to)
{
    const Nearest end = nearestOnBox(half, to);
    if (const std::optional<Vec3> normal = faceEntered(half, from, to)) {
        const double height = half.dot(normal->cwiseAbs()) + margin;
        return touchOnPlane(to, height * *normal, *normal);
    }
    if (end.distance >= margin)
        return std::nullopt;
    return Touch{end.moved(to, margin), end.normal};
}

std::optional<Touch> touchSphere(double radius, const Vec3& from, const Vec3& to)
{
    const Nearest end = nearestOnSphere(radius, to);
    const bool isOutside = end.distance >= 0.0;
    const bool fromOutside = nearestOnSphere(radius, from).distance > -onSurface * radius;
    if (fromOutside)
        if (const std::optional<Vec3> normal = entered(radius, from, to);
            normal && (isOutside || normal->dot(end.normal) < lightly))
            return touchOnPlane(to, radius * *normal, *normal);
    return isOutside ? std::nullopt : std::optional(Touch{radius * end.normal, end.normal});
}

} // namespace ripstop
