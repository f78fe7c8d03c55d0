// under() goes through the kinds in the order in which a person aims: particles within eight
// pixels (five where they have no dots), links within five, from the nearest to the farthest, each
// only if no panel or collider hides the place; then whichever of panel and collider the ray meets
// first.
//
// particlesNear() and linksNear() measure in the picture. The place on a link is found with the
// depths of its ends, as half way in the picture is not half way in the world.
#include "tools/picker.h"

#include "camera/occlusion.h"
#include "look/loose_particles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double particleReach = 8.0; // pixels
constexpr double cornerReach = 5.0;   // pixels, to a particle without a dot
constexpr double linkReach = 5.0;     // pixels
constexpr double never = std::numeric_limits<double>::infinity();

struct Near
{
    double distance; // pixels, from the cursor
    std::size_t element;
    double share; // of the way along a link
};

void sortByDistance(std::vector<Near>& found)
{
    std::ranges::sort(found, {},
                      [](const Near& one) { return std::pair(one.distance, one.element); });
}

std::vector<Near> particlesNear(const Picker& picker, std::span<const OnScreen> points, double x,
                                double y)
{
    std::vector<Near> found;
    const Layout& layout = *picker.view.frame.layout;
    const std::vector<std::uint8_t> isLoose = looseParticles(picker.view.frame);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double dx = points[i].x - x, dy = points[i].y - y;
        const double reach =
            picker.pickable.hasDot(layout.pinned[i], isLoose[i]) ? particleReach : cornerReach;
        if (points[i].isSeen() && dx * dx + dy * dy < reach * reach
            && picker.view.look.particleShown[i] && picker.pickable.particles())
            found.push_back({std::hypot(dx, dy), i, 0.0});
    }
    sortByDistance(found);
    return found;
}

std::vector<Near> linksNear(const Picker& picker, std::span<const OnScreen> points, double x,
                            double y)
{
    std::vector<Near> found;
    const Layout& layout = *picker.view.frame.layout;
    for (std::size_t i = 0; picker.pickable.links() && i < layout.links.size(); ++i) {
        const OnScreen& a = points[std::size_t(layout.links[i].a)];
        const OnScreen& b = points[std::size_t(layout.links[i].b)];
        if (!a.isSeen() || !b.isSeen() || picker.view.frame.torn[i]
            || !picker.view.look.linkShown[i])
            continue;
        const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
        const double along = squared > 0.0 ? ((x - a.x) * dx + (y - a.y) * dy) / squared : 0.0;
        const double t = std::clamp(along, 0.0, 1.0);
        const double away = std::hypot(a.x + t * dx - x, a.y + t * dy - y);
        if (!(away < linkReach))
            continue;
        // Half way along a link in the picture is not half way along it where one end is near.
        const bool flat = picker.view.camera.orthographic;
        const double share = flat ? t : t * a.depth / ((1.0 - t) * b.depth + t * a.depth);
        found.push_back({away, i, share});
    }
    sortByDistance(found);
    return found;
}

struct Hit
{
    Id id;
    double distance; // m along the ray
};

Hit colliderUnder(const CameraView& view, const CameraProjection::Ray& ray)
{
    Hit best{noId, never};
    for (const ColliderBody& body : view.colliders) {
        if (!body.collider.shown)
            continue;
        const Vec3 place = placeOf(view.frame, body.id, body.collider);
        if (const double t = distanceTo(body, place, ray.origin, ray.direction); t < best.distance)
            best = {body.id, t};
    }
    return best;
}

} // namespace

std::vector<OnScreen> projected(const CameraView& view)
{
    const CameraProjection projection(view);
    std::vector<OnScreen> points;
    points.reserve(view.frame.position.size());
    for (const Vec3& place : view.frame.position)
        points.push_back(projection(place));
    return points;
}

Picked Picker::under(double x, double y) const
{
    const std::vector<OnScreen> points = projected(view);
    const Eigen::Vector2d reach(particleReach, particleReach);
    const Eigen::AlignedBox2d around(Eigen::Vector2d(x, y) - reach, Eigen::Vector2d(x, y) + reach);
    const Occlusion occlusion(view, points, around, pickable.drawn.panels);
    const Layout& layout = *view.frame.layout;
    const auto& places = view.frame.position;

    for (const Near& near : particlesNear(*this, points, x, y)) {
        const int own[]{int(near.element)};
        if (!occlusion.hides({places[near.element], own}))
            return {Picked::Sort::Particle, Id(layout.particleId[near.element]), near.element,
                    places[near.element]};
    }
    for (const Near& near : linksNear(*this, points, x, y)) {
        const auto& link = layout.links[near.element];
        const int own[]{link.a, link.b};
        const Vec3& from = places[std::size_t(link.a)];
        const Vec3 way = places[std::size_t(link.b)] - from;
        const Vec3 place = from + near.share * way;
        if (!occlusion.hides({place, own, Occlusion::foldOf(way.norm())}))
            return {Picked::Sort::Link, Id(link.id), near.element, place};
    }
    const Occlusion::Met panel = occlusion.firstPanel(x, y);
    const CameraProjection::Ray ray = CameraProjection(view).rayAt(x, y);
    const Hit collider = colliderUnder(view, ray);
    if (collider.distance < panel.distance)
        return {Picked::Sort::Collider, collider.id, 0,
                ray.origin + collider.distance * ray.direction};
    if (panel.panel < 0 || !pickable.panels())
        return {};
    return {Picked::Sort::Panel, Id(layout.panelId[std::size_t(panel.panel)]),
            std::size_t(panel.panel), ray.origin + panel.distance * ray.direction};
}

} // namespace ripstop
