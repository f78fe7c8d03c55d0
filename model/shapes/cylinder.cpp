// A cylinder in three stages:
// 1. The way into it: a way is crossed with the endless cylinder of the side and with the planes
//    of the caps; the later of the two crossings is where it enters, if the place lies on the
//    other surface as well. With a margin the shape is a wider and a taller cylinder, which are
//    asked first.
// 2. The answers to contact: the nearest place by distances beside and above, and the touch, by
//    the entry for points that came through and by the nearest place for light ones.
// 3. The answers to the view: a ray as a way that ends beyond the shape, and the faces.
#include "shapes/cylinder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

// --- the way into a cylinder

struct WayIn
{
    double share; // of the way
    Vec3 normal;  // unit, of side or cap
};

// Distance from the axis.
double reach(const Vec3& point) { return std::hypot(point.x(), point.z()); }

// One of the two surfaces that a way may have to cross: where it does, or why it does not.
struct Crossing
{
    enum class Kind { StartsBehind, Misses, Enters } kind;
    double share = 0.0;
};

// Crosses the way with the endless cylinder. A start on the surface counts as outside of it.
Crossing throughSide(double radius, double slack, const Vec3& from, const Vec3& way)
{
    if (reach(from) - radius < -slack)
        return {Crossing::Kind::StartsBehind};
    const double squared = way.x() * way.x() + way.z() * way.z();
    const double along = -(from.x() * way.x() + from.z() * way.z());
    const double beyond = from.x() * from.x() + from.z() * from.z() - radius * radius;
    const double root = along * along - squared * beyond;
    if (along <= 0.0 || root <= 0.0)
        return {Crossing::Kind::Misses};
    const double entry = std::max(0.0, along - std::sqrt(root));
    if (entry > squared)
        return {Crossing::Kind::Misses};
    return {Crossing::Kind::Enters, entry / squared};
}

// Crosses the way with the endless plane of the cap that the start is nearer to.
Crossing throughCap(double half, double slack, const Vec3& from, const Vec3& way)
{
    const double gap = std::abs(from.y()) - half;
    if (gap < -slack)
        return {Crossing::Kind::StartsBehind};
    const double inwards = from.y() < 0.0 ? way.y() : -way.y();
    if (inwards <= gap || inwards <= 0.0)
        return {Crossing::Kind::Misses};
    return {Crossing::Kind::Enters, gap > 0.0 ? gap / inwards : 0.0};
}

// Where the way of a point that starts outside enters, or nothing.
std::optional<WayIn> entered(const Cylinder& cylinder, const Vec3& from, const Vec3& to)
{
    const double slack = onSurface * std::max(cylinder.radius, cylinder.half);
    const Vec3 way = to - from;
    const Crossing cap = throughCap(cylinder.half, slack, from, way);
    if (cap.kind == Crossing::Kind::Misses)
        return std::nullopt;
    const Crossing side = throughSide(cylinder.radius, slack, from, way);
    if (side.kind == Crossing::Kind::Misses)
        return std::nullopt;
    const bool byCap = cap.kind == Crossing::Kind::Enters
                       && (side.kind != Crossing::Kind::Enters || cap.share > side.share);
    if (!byCap && side.kind != Crossing::Kind::Enters)
        return std::nullopt; // it starts inside
    const double share = byCap ? cap.share : side.share;
    const Vec3 place = from + share * way;
    if (byCap)
        return reach(place) > cylinder.radius + slack
                   ? std::nullopt
                   : std::optional(WayIn{share, (from.y() < 0.0 ? -1.0 : 1.0) * Vec3::UnitY()});
    if (std::abs(place.y()) > cylinder.half + slack)
        return std::nullopt;
    return WayIn{share, Vec3(place.x(), 0.0, place.z()).normalized()};
}

// Where the way enters the shape with its margin. That is a wider cylinder and a taller one, with a
// ring around each rim; a way through a ring is looked at where it comes to the cylinder within.
std::optional<WayIn> enteredWithMargin(const Cylinder& cylinder, double margin, const Vec3& from,
                                       const Vec3& to)
{
    if (margin > 0.0) {
        const auto wide = entered({cylinder.radius + margin, cylinder.half}, from, to);
        if (wide && wide->normal.y() == 0.0)
            return wide;
        const auto tall = entered({cylinder.radius, cylinder.half + margin}, from, to);
        if (tall && tall->normal.y() != 0.0)
            return tall;
    }
    return entered(cylinder, from, to);
}

} // namespace

Nearest nearestOnCylinder(const Cylinder& cylinder, const Vec3& point)
{
    const double r = reach(point);
    // On the very axis every way out is equally short.
    const Vec3 out = r > 0.0 ? Vec3(point.x() / r, 0.0, point.z() / r) : Vec3(1.0, 0.0, 0.0);
    const Vec3 up = (point.y() < 0.0 ? -1.0 : 1.0) * Vec3::UnitY();
    const double beside = r - cylinder.radius;
    const double above = std::abs(point.y()) - cylinder.half;
    if (beside > 0.0 && above > 0.0) {
        const double distance = std::hypot(beside, above);
        return {distance, (beside * out + above * up) / distance};
    }
    return beside > above ? Nearest{beside, out} : Nearest{above, up};
}

std::optional<Touch> touchCylinder(const Cylinder& cylinder, double margin, const Vec3& from,
                                   const Vec3& to)
{
    const Nearest end = nearestOnCylinder(cylinder, to);
    const bool isOutside = end.distance >= margin;
    if (const auto entry = enteredWithMargin(cylinder, margin, from, to)) {
        const Vec3& normal = entry->normal;
        if (normal.y() != 0.0)
            return touchOnPlane(to, (cylinder.half + margin) * normal, normal);
        if (isOutside || normal.dot(end.normal) < lightly)
            return touchOnPlane(to, (cylinder.radius + margin) * normal, normal);
    }
    return isOutside ? std::nullopt : std::optional(Touch{end.moved(to, margin), end.normal});
}

double rayToCylinder(const Cylinder& cylinder, const ShapeRay& ray)
{
    // The ray is taken as a way that ends beyond the shape.
    const double size = std::hypot(cylinder.radius, cylinder.half);
    const double length = (ray.origin.norm() + 2.0 * size) / ray.direction.norm();
    const auto entry = entered(cylinder, ray.origin, ray.origin + length * ray.direction);
    return entry ? entry->share * length : noHit;
}

ShapeSurface cylinderSurface(const Cylinder& cylinder)
{
    constexpr int around = 72;
    ShapeSurface surface;
    for (const double y : {-cylinder.half, cylinder.half})
        surface.points.emplace_back(0.0, y, 0.0);
    for (int i = 0; i < around; ++i)
        for (const double y : {-cylinder.half, cylinder.half}) {
            const double angle = 2.0 * std::numbers::pi * i / around;
            surface.points.emplace_back(cylinder.radius * std::cos(angle), y,
                                        cylinder.radius * std::sin(angle));
        }
    for (int i = 0; i < around; ++i) {
        const int low = 2 + 2 * i, next = 2 + 2 * ((i + 1) % around);
        surface.faces.push_back({low, low + 1, next + 1, next});
        surface.faces.push_back({0, low, next, -1});
        surface.faces.push_back({1, next + 1, low + 1, -1});
    }
    return surface;
}

} // namespace ripstop
