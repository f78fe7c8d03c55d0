// Winds that are the same everywhere, and what they blow at: one finding for each part. What stays
// flat without wind is asked of the scene as a whole, as anything outside of the plane may pull or
// push out of it.
#include "check/flutter_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

constexpr double unseen = 1e-9; // of the length of what lies in the plane

bool isIn(const Vec3& normal, const Vec3& way)
{
    return std::abs(normal.dot(way)) <= unseen * way.norm();
}

// The wind of the scene, m/s; nothing where it differs from place to place or from time to time.
std::optional<Vec3> steadyWind(const Scene& scene)
{
    Vec3 sum = Vec3::Zero();
    for (const Entry& entry : scene.items)
        if (const Wind* wind = std::get_if<Wind>(&entry.item)) {
            if (wind->kind != WindKind::Uniform)
                return std::nullopt;
            sum += wind->velocity;
        }
    return sum;
}

struct Plane
{
    Vec3 point;
    Vec3 normal; // of length 1

    bool holds(const Particle& particle) const
    {
        return isIn(normal, particle.position - point) && isIn(normal, particle.velocity);
    }
    bool holds(const Part& part) const
    {
        return std::ranges::all_of(part.particles,
                                   [this](const Particle& particle) { return holds(particle); });
    }
};

// The plane in which all of a part lies and moves; nothing where there is none.
std::optional<Plane> planeOf(const Part& part)
{
    if (part.panels.empty())
        return std::nullopt;
    const auto at = [&](Id id) { return findRow(part.particles, id); };
    const Panel& first = part.panels.front();
    const Particle* const a = at(first.a);
    const Particle* const b = at(first.b);
    const Particle* const c = at(first.c);
    if (!a || !b || !c)
        return std::nullopt;
    const Vec3 normal = (b->position - a->position).cross(c->position - a->position);
    if (!(normal.norm() > 0.0))
        return std::nullopt;
    const Plane plane{a->position, normal.normalized()};
    return plane.holds(part) ? std::optional(plane) : std::nullopt;
}

bool meetsAir(const Scene& scene, const Panel& panel)
{
    const Material* const material = findItem<Material>(scene, panel.material);
    return !material || material->airLaw != AirLaw::None;
}

// Whether what an item does leaves all that lies in the plane there.
bool staysIn(const Plane& plane, const Item& item)
{
    if (const auto* part = std::get_if<Part>(&item))
        return plane.holds(*part) && part->canopyPressure == 0.0
               && std::ranges::all_of(part->particles, [&](const Particle& particle) {
                      return particle.guide == Guide::None
                             || isIn(plane.normal, particle.guideAxis);
                  });
    if (const auto* collider = std::get_if<Collider>(&item))
        return collider->shape == ColliderShape::Plane && isIn(plane.normal, collider->normal);
    if (const auto* control = std::get_if<Control>(&item))
        return isIn(plane.normal, control->axis);
    return true;
}

} // namespace

void checkFlutter(const Scene& scene, const AddFinding& add)
{
    const std::optional<Vec3> wind = steadyWind(scene);
    if (!wind || wind->isZero(0.0) || scene.settings.airDensity == 0.0)
        return;
    forEachPart(scene, [&](Id id, const Part& part) {
        const std::optional<Plane> plane = planeOf(part);
        if (plane && isIn(plane->normal, *wind) && isIn(plane->normal, scene.settings.gravity)
            && std::ranges::any_of(part.panels,
                                   [&](const Panel& panel) { return meetsAir(scene, panel); }))
            add("flutter", Severity::Warning,
                Message(
                    "The fabric of %1 lies in one plane with the wind and stays there, as "
                    "nothing moves it aside: it does not flutter. Turn the wind by a degree, or "
                    "give it gusts.",
                    part.name),
                id);
    });
}

std::vector<Id> partsThatStayFlat(const Scene& scene)
{
    const bool isCalm =
        scene.settings.airDensity == 0.0 || steadyWind(scene).value_or(Vec3::Ones()).isZero(0.0);
    if (!isCalm || scene.settings.gravity.isZero(0.0))
        return {};
    std::optional<Plane> plane;
    std::vector<Id> parts;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (part.panels.empty())
            return;
        if (!plane)
            plane = planeOf(part);
        parts.push_back(id);
    });
    const bool stays = plane && isIn(plane->normal, scene.settings.gravity)
                       && std::ranges::all_of(scene.items, [&](const Entry& entry) {
                              return staysIn(*plane, entry.item);
                          });
    return stays ? parts : std::vector<Id>();
}

} // namespace ripstop
