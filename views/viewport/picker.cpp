#include "viewport/picker.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double particleReach = 8.0; // pixels
constexpr double linkReach = 5.0;     // pixels
constexpr double never = std::numeric_limits<double>::infinity();

struct Ray
{
    Vec3 origin;    // m
    Vec3 direction; // unit
};

struct Hit
{
    Id id = noId;
    double depth = never; // m along the ray
};

Ray rayAt(const Picker& picker, double x, double y)
{
    const Turntable& camera = picker.camera;
    const double right = (2.0 * x / picker.width - 1.0) * picker.width / picker.height;
    const double up = 1.0 - 2.0 * y / picker.height;
    const double half = camera.halfHeight();
    const Vec3 target = camera.focus + half * (right * camera.right() + up * camera.up());
    if (camera.orthographic) {
        // from far behind the eye: an orthographic camera sees what is beside it, too
        const double away = 1e3 * camera.distance;
        return {target + away * camera.back(), -camera.back()};
    }
    return {camera.eye(), (target - camera.eye()).normalized()};
}

// Moeller and Trumbore 1997.
double distanceToPanel(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 e1 = b - a, e2 = c - a;
    const Vec3 p = ray.direction.cross(e2);
    const double determinant = e1.dot(p);
    if (determinant == 0.0)
        return never;
    const Vec3 s = ray.origin - a;
    const double u = s.dot(p) / determinant;
    const Vec3 q = s.cross(e1);
    const double v = ray.direction.dot(q) / determinant;
    const double t = e2.dot(q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : never;
}

Hit panelUnder(const Picker& picker, const Ray& ray)
{
    Hit best;
    const Layout& layout = *picker.frame.layout;
    for (std::size_t i = 0; i < layout.panelId.size(); ++i) {
        if (picker.frame.gone[i] || !picker.look.panelShown[i])
            continue;
        const auto [a, b, c] = layout.panelCorners[i];
        const auto& x = picker.frame.position;
        if (const double t = distanceToPanel(ray, x[a], x[b], x[c]); t < best.depth)
            best = {Id(layout.panelId[i]), t};
    }
    return best;
}

Hit colliderUnder(const Picker& picker, const Ray& ray)
{
    Hit best;
    for (const ColliderBody& body : picker.colliders) {
        if (!body.collider.shown)
            continue;
        const Vec3 place = placeOf(picker.frame, body.id, body.collider);
        if (const double t = distanceTo(body, place, ray.origin, ray.direction); t < best.depth)
            best = {body.id, t};
    }
    return best;
}

// The particles in the picture: x, y in pixels from the cursor, depth in m along the view.
struct Projected
{
    double x, y, depth;
};

std::vector<Projected> project(const Picker& picker, double x, double y)
{
    const Eigen::Matrix4d matrix = picker.camera.projection(picker.width / picker.height);
    std::vector<Projected> result;
    result.reserve(picker.frame.position.size());
    for (const Vec3& position : picker.frame.position) {
        const Eigen::Vector4d p = matrix * position.homogeneous();
        if (p.w() <= 0.0) {
            result.push_back({never, never, never}); // behind the eye
            continue;
        }
        result.push_back({0.5 * (p.x() / p.w() + 1.0) * picker.width - x,
                          0.5 * (1.0 - p.y() / p.w()) * picker.height - y, p.z()});
    }
    return result;
}

} // namespace

Id Picker::at(double x, double y) const
{
    const Ray ray = rayAt(*this, x, y);
    const Hit panel = pickable.panels ? panelUnder(*this, ray) : Hit{};
    const Hit collider = colliderUnder(*this, ray);

    // what is a little behind the surface is on it: links and particles lie in their panels
    const Vec3 cover = ray.origin + std::min(panel.depth, collider.depth) * ray.direction;
    const double slack = 0.01 * camera.distance;
    const double coverDepth =
        std::isfinite(cover.sum()) ? (camera.eye() - cover).dot(camera.back()) + slack : never;

    const std::vector<Projected> points = project(*this, x, y);
    const Layout& layout = *frame.layout;
    Id best = noId;
    double nearest = particleReach;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool seen = look.particleShown[i] && (pickable.particles || layout.pinned[i]);
        const double distance = std::hypot(points[i].x, points[i].y);
        if (seen && points[i].depth < coverDepth && distance < nearest) {
            nearest = distance;
            best = Id(layout.particleId[i]);
        }
    }
    if (best != noId)
        return best;

    nearest = linkReach;
    for (std::size_t i = 0; pickable.links && i < layout.links.size(); ++i) {
        if (frame.torn[i] || !look.linkShown[i])
            continue;
        const Projected& a = points[layout.links[i].a];
        const Projected& b = points[layout.links[i].b];
        if (a.depth == never || b.depth == never)
            continue;
        const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
        const double along = squared > 0.0 ? -(a.x * dx + a.y * dy) / squared : 0.0;
        const double t = std::clamp(along, 0.0, 1.0);
        const double distance = std::hypot(a.x + t * dx, a.y + t * dy);
        if (distance < nearest && a.depth + t * (b.depth - a.depth) < coverDepth) {
            nearest = distance;
            best = Id(layout.links[i].id);
        }
    }
    if (best != noId)
        return best;
    return panel.depth <= collider.depth ? panel.id : collider.id;
}

} // namespace ripstop
