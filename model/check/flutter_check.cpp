// Winds that are the same everywhere, and what they blow at: one finding for each part.
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

// The normal of the plane in which all of a part lies and moves; nothing where there is none.
std::optional<Vec3> planeOf(const Part& part)
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
    const Vec3 n = normal.normalized();
    const bool isFlat = std::ranges::all_of(part.particles, [&](const Particle& particle) {
        return isIn(n, particle.position - a->position) && isIn(n, particle.velocity);
    });
    return isFlat ? std::optional(n) : std::nullopt;
}

bool meetsAir(const Scene& scene, const Panel& panel)
{
    const Material* const material = findItem<Material>(scene, panel.material);
    return !material || material->airLaw != AirLaw::None;
}

} // namespace

void checkFlutter(const Scene& scene, const AddFinding& add)
{
    const std::optional<Vec3> wind = steadyWind(scene);
    if (!wind || wind->isZero(0.0) || scene.settings.airDensity == 0.0)
        return;
    forEachPart(scene, [&](Id id, const Part& part) {
        const std::optional<Vec3> normal = planeOf(part);
        if (normal && isIn(*normal, *wind) && isIn(*normal, scene.settings.gravity)
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

} // namespace ripstop
