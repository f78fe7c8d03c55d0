// Contact of particles with obstacles, in the order in which a particle meets it.
//
// The kernel compares the ways of four particles with the planes and the bounds of all obstacles,
// and calls resolveContact() only for those that may touch one. That goes over the obstacles in
// their order: touched() (obstacle_touch.h) asks for the place and the normal; touchOnGuide() turns
// these along a guide; rebound() says what is left of the velocity. Then the particle is put on the
// surface, and what friction holds does not creep.
//
// A particle writes to itself alone, so particles are shared out to threads in any way.
#include "contact/contact.h"

#include "constraints/guides.h"
#include "contact/obstacle_touch.h"
#include "parallel/simd_pack.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace ripstop {
namespace {

constexpr int lookInsideEvery = 16; // substeps; lets out what an edit put into a closed mesh

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

// What a particle on a guide meets of a surface: the normal is that within the guide, and the way
// out leads along it. There is no touch where the guide runs along the surface, as nothing could be
// done.
std::optional<Touch> touchOnGuide(const GuidedParticle& guided, const Touch& touch, const Vec3& at)
{
    constexpr double alongSurface = 0.02; // sine of the angle between guide and surface
    const Vec3 within = guided.freePart(touch.normal);
    const double steepness = within.norm();
    if (steepness < alongSurface)
        return std::nullopt;
    const Vec3 normal = within / steepness;
    const double depth = (touch.surface - at).dot(touch.normal);
    return Touch{at + depth / steepness * normal, normal};
}

struct ContactWork
{
    const System& system;
    State& state;
    std::span<const PaddedVec3> before; // [particles] m
    std::span<const PlacedObstacle> placed;
    double h;         // s
    double restSpeed; // m/s
    bool planesOnly;
    std::span<std::uint32_t> touches;   // [particles]
    std::span<const std::uint8_t> held; // [particles] or empty
};

// Goes over the obstacles in their order, as one may push a particle into the next. A particle is
// looked at only if it may have touched one of them.
void resolveContact(const ContactWork& work, std::size_t i)
{
    const auto& [system, state, before, placed, h, restSpeed, planesOnly, touches, held] = work;
    if (system.inverseMass[i] == 0.0 || (!held.empty() && held[i] != 0))
        return;
    const bool verlet = system.integrator == Integrator::Verlet;
    const bool inside = state.substep % lookInsideEvery == 0;
    const GuidedParticle* const guided = guideOf(system, int(i));
    for (std::size_t o = 0; o < placed.size(); ++o) {
        const Obstacle& obstacle = system.obstacles[o];
        const Vec3 start = before[i] + placed[o].way; // as if the obstacle had been there already
        std::optional<Touch> found =
            touched(obstacle, placed[o], {start, state.position[i]}, inside);
        if (found && guided)
            found = touchOnGuide(*guided, *found, state.position[i]);
        if (!found)
            continue;
        touches[i] |= touchOf(o);
        const Vec3& n = found->normal;
        const Vec3 pace = placed[o].way / h; // m/s, of the surface
        const Rebound now = rebound(obstacle, state.velocity[i] - pace, n, restSpeed);
        const Rebound lag = rebound(obstacle, state.drift[i] - pace, n, restSpeed);
        state.velocity[i] = now.velocity + pace;
        if (isVerlet(system.integrator))
            state.drift[i] = lag.velocity + pace;

        // What holds a particle also takes back the way it went along the surface in this
        // substep; otherwise whatever sticks to a slope would creep down by g h sin(slope).
        const Vec3 way = found->surface - start;
        const double kept = verlet ? lag.kept : now.kept;
        state.position[i] = found->surface - (1.0 - kept) * (way - way.dot(n) * n);
    }
}

} // namespace
} // namespace ripstop

#define RIPSTOP_KERNEL "contact/contact_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

void resolveContacts(const System& system, State& state, std::span<const PaddedVec3> before,
                     std::span<const PlacedObstacle> placed, double h, ThreadPool& pool,
                     std::span<std::uint32_t> touches, std::span<const std::uint8_t> held)
{
    if (system.obstacles.empty())
        return;
    const bool planesOnly =
        std::all_of(system.obstacles.begin(), system.obstacles.end(),
                    [](const Obstacle& o) { return o.shape == ColliderShape::Plane; });
    const ContactWork work = {system,     state,   before,
                              placed,     h,       2.0 * system.gravity.norm() * h,
                              planesOnly, touches, held};
    pool.parallelFor(state.position.size(), [&](std::size_t first, std::size_t last) {
        (wideMachine ? wide::findContacts : anywhere::findContacts)(work, first, last);
    });
}

} // namespace ripstop
