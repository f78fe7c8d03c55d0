#include "sim/contact.h"

#include <algorithm>
#include <optional>

namespace ripstop {
namespace {

struct Touch
{
    Vec3 surface; // m
    Vec3 normal;  // unit, outwards
};

std::optional<Touch> touch(const Obstacle& obstacle, const Vec3& position)
{
    const Vec3 offset = position - obstacle.position;
    if (obstacle.shape == ColliderShape::Plane) {
        const double height = offset.dot(obstacle.normal);
        if (height >= 0.0)
            return std::nullopt;
        return Touch{position - height * obstacle.normal, obstacle.normal};
    }
    const double distance = offset.norm();
    if (distance >= obstacle.radius)
        return std::nullopt;
    // At the very centre every way out is equally short.
    const Vec3 normal = distance > 0.0 ? Vec3(offset / distance) : Vec3(0.0, 1.0, 0.0);
    return Touch{obstacle.position + obstacle.radius * normal, normal};
}

Vec3 leftOver(const Obstacle& obstacle, const Vec3& velocity, const Vec3& normal, double restSpeed)
{
    const double inward = -velocity.dot(normal); // m/s
    if (obstacle.response == Response::Stop)
        return Vec3::Zero();
    if (inward <= 0.0)
        return velocity;
    const Vec3 along = velocity + inward * normal;
    if (obstacle.response == Response::Slide)
        return along;
    const double restitution = inward > restSpeed ? obstacle.restitution : 0.0;
    const double impulse = (1.0 + restitution) * inward; // per mass
    const double sliding = along.norm();
    const double kept =
        sliding > 0.0 ? std::max(0.0, 1.0 - obstacle.friction * impulse / sliding) : 0.0;
    return kept * along + (restitution * inward) * normal;
}

} // namespace

void resolveContacts(const System& system, State& state, double h, Crew& crew)
{
    if (system.obstacles.empty())
        return;
    const double restSpeed = 2.0 * system.gravity.norm() * h;
    crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (system.inverseMass[i] == 0.0)
                continue;
            for (const Obstacle& obstacle : system.obstacles) {
                const std::optional<Touch> found = touch(obstacle, state.position[i]);
                if (!found)
                    continue;
                state.position[i] = found->surface;
                state.velocity[i] = leftOver(obstacle, state.velocity[i], found->normal, restSpeed);
                state.drift[i] = leftOver(obstacle, state.drift[i], found->normal, restSpeed);
            }
        }
    });
}

} // namespace ripstop
