#include "step/watchdog.h"

#include "assembly/split_system.h"
#include "contact/start_depth.h"
#include "forces/spring_force.h"
#include "laws/step_limit.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// s; without end when there are no springs.
double springLimitAt(const System& system, const State& state, std::size_t particle)
{
    const auto [stiffness, damping] = springsAt(system, state, particle);
    return springStepLimit(1.0 / system.inverseMass[particle], stiffness, damping,
                           system.integrator);
}

double largestMassRatio(const System& system, std::size_t particle)
{
    double ratio = 1.0;
    for (int k = system.rodsAt.start[particle]; k < system.rodsAt.start[particle + 1]; ++k) {
        const Rod& rod = system.rods[std::size_t(system.rodsAt.items[std::size_t(k)])];
        const double wa = system.inverseMass[std::size_t(rod.a)];
        const double wb = system.inverseMass[std::size_t(rod.b)];
        if (wa > 0.0 && wb > 0.0)
            ratio = std::max({ratio, wa / wb, wb / wa});
    }
    return ratio;
}

// What contact put outside of an obstacle in the first step stretched what it was tied to.
Message toldOf(const StartDepth& start)
{
    const Message depth = Message::number("%.3g", start.deepest);
    return start.particles == 1
               ? Message("likely because a particle began inside an obstacle, by %1 m; move it or "
                         "the obstacle",
                         depth)
               : Message("likely because %1 particles began inside obstacles, by up to %2 m; move "
                         "them or the obstacles",
                         start.particles, depth);
}

// The most likely cause first: what the element itself says about the step.
Message causeAt(const System& system, const State& before, int substeps, std::size_t particle)
{
    const double h = system.timeStep / substeps;
    const double limit = springLimitAt(system, before, particle);
    if (h > limit)
        return Message("the substep of %1 s is above the %2 s that its springs allow; shorten the "
                       "time step, add substeps, or lower stiffness and damping",
                       Message::number("%.3g", h), Message::number("%.3g", limit));
    if (system.integrator == Integrator::ExplicitEuler && std::isfinite(limit))
        return Message("explicit Euler gains energy from springs at any time step; choose another "
                       "integrator or add damping");
    if (const double ratio = largestMassRatio(system, particle); ratio > 1000.0)
        return Message("a rod joins it to a particle of %1 times another mass; add substeps or "
                       "bring the masses closer",
                       Message::number("%.0f", ratio));
    if (const StartDepth start = startDepth(system); start.particles > 0)
        return toldOf(start);
    return Message("something pushes it harder than the time step resolves; shorten the time step "
                   "or look at the forces there");
}

} // namespace

std::optional<Trouble> findTrouble(const System& system, const State& before, const State& after,
                                   int substeps)
{
    const double limit = system.speedLimit * system.speedLimit;
    for (std::size_t i = 0; i < after.position.size(); ++i) {
        if (after.velocity[i].squaredNorm() <= limit && after.position[i].allFinite())
            continue;
        const double speed = after.velocity[i].norm();
        const bool finite = std::isfinite(speed) && after.position[i].allFinite();
        if (finite && speed <= system.speedLimit)
            continue;
        const Key key = TwinOrigins(after.splits).particle(system.key[i]);
        Trouble trouble{after.time, key, {}};
        const Message time = Message::number("%.4f", after.time);
        const Message cause = causeAt(system, before, substeps, i);
        trouble.message =
            finite ? Message("particle %1 reached %2 m/s, above the limit of %3 m/s, at %4 s: %5",
                             key, Message::number("%.3g", speed),
                             Message::number("%.3g", system.speedLimit), time, cause)
                   : Message("particle %1 left the range of numbers at %2 s: %3", key, time, cause);
        return trouble;
    }
    return std::nullopt;
}

} // namespace ripstop
