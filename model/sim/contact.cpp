#include "sim/contact.h"

#include "sim/four.h"

#include <algorithm>
#include <cstdint>
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

struct Rebound
{
    Vec3 velocity; // m/s
    double kept;   // share of the motion along the surface that is left
};

Rebound rebound(const Obstacle& obstacle, const Vec3& velocity, const Vec3& normal,
                double restSpeed)
{
    const double inward = -velocity.dot(normal); // m/s
    if (obstacle.response == Response::Stop)
        return {Vec3::Zero(), 0.0};
    if (inward <= 0.0)
        return {velocity, 1.0};
    const Vec3 along = velocity + inward * normal;
    if (obstacle.response == Response::Slide)
        return {along, 1.0};
    const double restitution = inward > restSpeed ? obstacle.restitution : 0.0;
    const double impulse = (1.0 + restitution) * inward; // per mass
    const double sliding = along.norm();
    const double kept =
        sliding > 0.0 ? std::max(0.0, 1.0 - obstacle.friction * impulse / sliding) : 0.0;
    return {kept * along + (restitution * inward) * normal, kept};
}

struct ContactWork
{
    const System& system;
    State& state;
    std::span<const PaddedVec3> before; // [particles] m
    double restSpeed;                   // m/s
};

// In the order of the obstacles: one may push a particle into the next. A particle is looked at
// only if it began inside of one of them.
void resolveContact(const ContactWork& work, std::size_t i)
{
    const auto& [system, state, before, restSpeed] = work;
    if (system.inverseMass[i] == 0.0)
        return;
    const bool verlet = system.integrator == Integrator::Verlet;
    for (const Obstacle& obstacle : system.obstacles) {
        const std::optional<Touch> found = touch(obstacle, state.position[i]);
        if (!found)
            continue;
        const Vec3& n = found->normal;
        const Rebound now = rebound(obstacle, state.velocity[i], n, restSpeed);
        const Rebound lag = rebound(obstacle, state.drift[i], n, restSpeed);
        state.velocity[i] = now.velocity;
        state.drift[i] = lag.velocity;

        // What holds a particle also takes back the way it went along the surface in this
        // substep; else whatever sticks to a slope creeps down by g h sin(slope).
        const Vec3 way = found->surface - before[i];
        const double kept = verlet ? lag.kept : now.kept;
        state.position[i] = found->surface - (1.0 - kept) * (way - way.dot(n) * n);
    }
}

} // namespace
} // namespace ripstop

#define RIPSTOP_KERNEL "sim/contact_kernel.inl"
#include "sim/for_each_machine.inl"

namespace ripstop {

void resolveContacts(const System& system, State& state, std::span<const PaddedVec3> before,
                     double h, Crew& crew)
{
    if (system.obstacles.empty())
        return;
    const ContactWork work = {system, state, before, 2.0 * system.gravity.norm() * h};
    crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        (wideMachine ? wide::findContacts : anywhere::findContacts)(work, first, last);
    });
}

} // namespace ripstop
