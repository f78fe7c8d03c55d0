#include "step/watchdog.h"

#include "assembly/split_system.h"
#include "base/step_limit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ripstop {
namespace {

std::string format(const char* pattern, auto... values)
{
    char text[240];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

// s; without end when there are no springs.
double springLimitAt(const System& system, const State& state, std::size_t particle)
{
    double stiffness = 0.0; // N/m
    double damping = 0.0;   // N s/m
    for (int k = system.springsAt.start[particle]; k < system.springsAt.start[particle + 1]; ++k) {
        const auto spring = std::size_t(system.springsAt.items[std::size_t(k)]);
        if (state.springTorn[spring])
            continue;
        stiffness += system.springs[spring].stiffness;
        damping += system.springs[spring].damping;
    }
    return springStepLimit(1.0 / system.inverseMass[particle], stiffness, damping);
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

// The most likely cause first: what the element itself says about the step.
std::string causeAt(const System& system, const State& before, int substeps, std::size_t particle)
{
    const double h = system.timeStep / substeps;
    const double limit = springLimitAt(system, before, particle);
    if (h > limit)
        return format("the substep of %.3g s is above the %.3g s that its springs allow; "
                      "shorten the time step, add substeps, or lower stiffness and damping",
                      h, limit);
    if (system.integrator == Integrator::ExplicitEuler && std::isfinite(limit))
        return "explicit Euler gains energy from springs at any time step; choose another "
               "integrator or add damping";
    if (const double ratio = largestMassRatio(system, particle); ratio > 1000.0)
        return format("a rod joins it to a particle of %.0f times another mass; add substeps or "
                      "bring the masses closer",
                      ratio);
    return "something pushes it harder than the time step resolves; shorten the time step or "
           "look at the forces there";
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
        trouble.message = "particle " + std::to_string(key)
                          + (finite ? format(" reached %.3g m/s, above the limit of %.3g m/s,",
                                             speed, system.speedLimit)
                                    : " left the range of numbers")
                          + format(" at %.4f s: ", after.time)
                          + causeAt(system, before, substeps, i);
        return trouble;
    }
    return std::nullopt;
}

} // namespace ripstop
