// handles() says which handles can be seen from here: an arrow end on and a square edge on are left
// out. shape() and behindShape() give their lines in the picture, and at() takes the nearest of
// these within a few pixels.
//
// shift(), factors() and angle() turn a way of the cursor into metres, factors and radians: along
// an axis by the plane through it that faces the eye most, in a plane by the meeting with the ray,
// freely by pixels. Where a ring is seen edge on, its angle is read along its line instead.
#include "tools/gizmo.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ripstop {
namespace {

constexpr double tolerance = 7.0;    // pixels
constexpr double squareNear = 0.28;  // of the reach, where the squares begin and end
constexpr double squareFar = 0.50;   // of the reach
constexpr double endOn = 0.985;      // cosine above which an arrow is seen end on
constexpr double edgeOn = 0.15;      // cosine below which a square or ring is seen edge on
constexpr double pixelsPerE = 150.0; // of a drag that scales evenly by 2.718
constexpr double smallest = 0.01;    // factor
constexpr int ringPoints = 64;

double lengthOf(QPointF way) { return std::hypot(way.x(), way.y()); }

double distanceTo(const QPolygonF& line, QPointF cursor)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF way = line[i] - line[i - 1];
        const QPointF rest = cursor - line[i - 1];
        const double squared = QPointF::dotProduct(way, way);
        const double along =
            squared > 0.0 ? std::clamp(QPointF::dotProduct(rest, way) / squared, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, lengthOf(rest - along * way));
    }
    return nearest;
}

// Where the ray meets the plane through `place`; `place` when it runs along the plane.
Vec3 onPlane(const CameraProjection::Ray& ray, const Vec3& place, const Vec3& normal)
{
    const double cosine = normal.dot(ray.direction);
    if (std::abs(cosine) < 1e-6)
        return place;
    return ray.origin + normal.dot(place - ray.origin) / cosine * ray.direction;
}

// Where along the axis the cursor is, m from the pivot. It is measured on the plane through the
// axis that the picture shows best; an axis that is seen end on gives 0.
double alongAxis(const Gizmo& gizmo, const Vec3& axis, QPointF cursor)
{
    const Vec3 back = gizmo.projection.camera().back();
    const Vec3 across = back - axis.dot(back) * axis;
    if (across.norm() < 1e-3)
        return 0.0; // the axis is seen end on
    return axis.dot(onPlane(gizmo.projection.rayAt(cursor), gizmo.pivot, across.normalized())
                    - gizmo.pivot);
}

} // namespace

std::array<bool, 3> Handle::axes() const
{
    std::array<bool, 3> changed{};
    for (int i = 0; i < 3; ++i)
        changed[std::size_t(i)] = sort == Sort::Free || (sort == Sort::Axis && i == axis)
                                  || (sort == Sort::Plane && i != axis);
    return changed;
}

std::vector<Handle> Gizmo::handles() const
{
    std::vector<Handle> seen;
    if (shaping == Shaping::None || !centre())
        return seen;
    const Vec3 eye = projection.towardsEye(pivot);
    if (shaping == Shaping::Turn)
        seen.push_back({Handle::Sort::Free, 0});
    for (int axis = 0; axis < 3; ++axis) {
        const double cosine = std::abs(axes.col(axis).dot(eye));
        if (shaping == Shaping::Turn || cosine < endOn)
            seen.push_back({Handle::Sort::Axis, axis});
        if (shaping != Shaping::Turn && cosine > edgeOn)
            seen.push_back({Handle::Sort::Plane, axis});
    }
    if (shaping != Shaping::Turn)
        seen.push_back({Handle::Sort::Free, 0});
    return seen;
}

QPolygonF Gizmo::shape(Handle handle) const
{
    const double size = reach * projection.metresPerPixel(pivot);
    QPolygonF line;
    const auto add = [&](const Vec3& offset) {
        if (const auto pixel = projection.pixel(pivot + size * offset))
            line << *pixel;
    };
    const auto centrePixel = centre();
    if (!centrePixel)
        return line;
    const Vec3 axis = axes.col(handle.axis);
    const Vec3 first = axes.col((handle.axis + 1) % 3), second = axes.col((handle.axis + 2) % 3);
    if (handle.sort == Handle::Sort::Free) {
        const double radius = shaping == Shaping::Turn ? viewReach : grip;
        for (int i = 0; i <= ringPoints; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / ringPoints;
            line << *centrePixel + radius * QPointF(std::cos(angle), std::sin(angle));
        }
    } else if (handle.sort == Handle::Sort::Plane) {
        for (const auto& [u, v] :
             std::array<std::pair<double, double>, 5>{{{squareNear, squareNear},
                                                       {squareFar, squareNear},
                                                       {squareFar, squareFar},
                                                       {squareNear, squareFar},
                                                       {squareNear, squareNear}}})
            add(u * first + v * second);
    } else if (shaping != Shaping::Turn) {
        add(Vec3::Zero());
        add(axis);
    } else {
        // A ring is drawn as the half that faces the eye, from one end to the other.
        const Vec3 eye = projection.towardsEye(pivot);
        const Vec3 inPlane = eye - axis.dot(eye) * axis;
        const Vec3 front = inPlane.norm() > 1e-6 ? Vec3(inPlane.normalized()) : first;
        const Vec3 side = axis.cross(front);
        const bool full = std::abs(axis.dot(eye)) > endOn;
        const double half = full ? std::numbers::pi : 0.5 * std::numbers::pi;
        for (int i = -ringPoints / 2; i <= ringPoints / 2; ++i) {
            const double angle = 2.0 * half * i / ringPoints;
            add(std::cos(angle) * front + std::sin(angle) * side);
        }
    }
    return line;
}

QPolygonF Gizmo::behindShape(int ring) const
{
    const Vec3 axis = axes.col(ring);
    const Vec3 eye = projection.towardsEye(pivot);
    const Vec3 inPlane = eye - axis.dot(eye) * axis;
    QPolygonF line;
    if (std::abs(axis.dot(eye)) > endOn || inPlane.norm() < 1e-6)
        return line;
    const double size = reach * projection.metresPerPixel(pivot);
    const Vec3 back = -inPlane.normalized();
    const Vec3 side = axis.cross(back);
    for (int i = -ringPoints / 2; i <= ringPoints / 2; ++i) {
        const double angle = std::numbers::pi * i / ringPoints;
        if (const auto pixel =
                projection.pixel(pivot + size * (std::cos(angle) * back + std::sin(angle) * side)))
            line << *pixel;
    }
    return line;
}

Handle Gizmo::at(QPointF cursor) const
{
    const auto centrePixel = centre();
    if (!centrePixel)
        return {};
    if (shaping != Shaping::Turn && lengthOf(cursor - *centrePixel) <= grip + 2.0)
        return {Handle::Sort::Free, 0};
    Handle best;
    double nearest = tolerance;
    for (const Handle& handle : handles()) {
        const QPolygonF line = shape(handle);
        const bool inside =
            handle.sort == Handle::Sort::Plane && line.containsPoint(cursor, Qt::OddEvenFill);
        const double distance = inside ? 0.0 : distanceTo(line, cursor);
        if (distance < nearest) {
            nearest = distance;
            best = handle;
        }
    }
    return best;
}

Vec3 Gizmo::shift(Handle handle, QPointF from, QPointF to) const
{
    const Vec3 axis = axes.col(handle.axis);
    if (handle.sort == Handle::Sort::Axis)
        return (alongAxis(*this, axis, to) - alongAxis(*this, axis, from)) * axis;
    const Vec3 normal = handle.sort == Handle::Sort::Plane ? axis : projection.camera().back();
    return onPlane(projection.rayAt(to), pivot, normal)
           - onPlane(projection.rayAt(from), pivot, normal);
}

Vec3 Gizmo::factors(Handle handle, QPointF from, QPointF to) const
{
    double factor = 1.0;
    if (handle.sort == Handle::Sort::Axis) {
        const Vec3 axis = axes.col(handle.axis);
        const double before = alongAxis(*this, axis, from);
        // a key may have chosen an axis that the hand did not take hold of
        const double size = 0.25 * reach * projection.metresPerPixel(pivot);
        const double change = alongAxis(*this, axis, to) - before;
        factor = 1.0 + change / (std::abs(before) > size ? before : 4.0 * size);
    } else {
        const QPointF way = to - from;
        factor = std::exp((way.x() - way.y()) / pixelsPerE);
    }
    factor = std::max(factor, smallest);
    Vec3 result = Vec3::Ones();
    for (int axis = 0; axis < 3; ++axis)
        if (handle.axes()[std::size_t(axis)])
            result[axis] = factor;
    return result;
}

Vec3 Gizmo::turningAxis(Handle handle) const
{
    return handle.sort == Handle::Sort::Axis ? Vec3(axes.col(handle.axis))
                                             : projection.towardsEye(pivot);
}

double Gizmo::angle(Handle handle, QPointF at) const
{
    const Vec3 axis = turningAxis(handle);
    const Vec3 eye = projection.towardsEye(pivot);
    if (std::abs(axis.dot(eye)) < edgeOn) {
        // Seen edge on, the ring is a line: along it, a radius of pixels is one radian.
        const Vec3 along = axis.cross(eye).normalized();
        const double size = projection.metresPerPixel(pivot);
        const auto start = centre(), end = projection.pixel(pivot + size * along);
        if (!start || !end || lengthOf(*end - *start) == 0.0)
            return 0.0;
        const QPointF unit = (*end - *start) / lengthOf(*end - *start);
        return QPointF::dotProduct(at - *start, unit) / reach;
    }
    const Vec3 arm = onPlane(projection.rayAt(at), pivot, axis) - pivot;
    const Vec3 zero = axis.unitOrthogonal();
    return std::atan2(arm.dot(axis.cross(zero)), arm.dot(zero));
}

} // namespace ripstop
