// A weight on one rod of 1 m: its period at any amplitude, and what projection takes from it.
//
// In order: the period from many amplitudes, as four times the time of the fall, against the
// elliptic integral; the period of many swings; and the decay that projection causes, which is that
// of implicit Euler.
#include "assembly/finish.h"
#include "base/angle.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <numbers>

namespace ripstop {
namespace {

System pendulum(double angle, double timeStep)
{
    System system = heavySystem(timeStep);
    addPin(system, Vec3::Zero());
    addParticle(system, {std::sin(angle), -std::cos(angle), 0.0}, 1.0);
    addRod(system, 0, 1, 1.0);
    system.solver = Solver::GaussSeidel;
    finish(system);
    return system;
}

double angleOf(const State& state)
{
    return std::atan2(state.position[1].x(), -state.position[1].y());
}

// Mean period between the passages through the lowest point, the first and the last of `swings`
// half periods; with no more than one passage, four times the time of fall.
double periodOf(double angle, double timeStep, int swings)
{
    const System system = pendulum(angle, timeStep);
    Stepper stepper;
    State state = system.start;
    double first = 0.0;
    double before = angle;
    for (int passages = 0; state.time < 60.0;) {
        stepper.step(system, state);
        const double now = angleOf(state);
        if ((before > 0.0) != (now > 0.0)) {
            const double time = state.time - timeStep * now / (now - before);
            if (swings == 0)
                return 4.0 * time;
            if (passages == 0)
                first = time;
            if (passages++ == swings)
                return 2.0 * (time - first) / swings;
        }
        before = now;
    }
    return 0.0;
}

// ln(first / last amplitude) over the time between, 1/s, of some 20 s from 10 degrees.
double decayOf(double timeStep)
{
    const System system = pendulum(10.0 * degrees, timeStep);
    Stepper stepper;
    State state = system.start;
    double speed = 0.0;
    double last = 10.0 * degrees;
    double time = 0.0;
    while (state.time < 20.2) {
        stepper.step(system, state);
        const double now = state.velocity[1].x();
        if (speed > 0.0 && now <= 0.0) {
            last = angleOf(state);
            time = state.time;
        }
        speed = now;
    }
    return std::log(10.0 * degrees / last) / time;
}

} // namespace

std::vector<Case> pendulumCases()
{
    std::vector<Case> cases;
    constexpr double periods[][2] = {{5.0, 2.00736469},   {10.0, 2.01023589}, {30.0, 2.04133847},
                                     {45.0, 2.08661218},  {60.0, 2.15324235}, {90.0, 2.36824635},
                                     {120.0, 2.75456019}, {150.0, 3.53570194}};
    const std::string source = "4 sqrt(L/g) K(sin(angle/2))";
    for (const auto& [angle, period] : periods)
        cases.push_back({"T-C3",
                         "period from " + std::to_string(int(angle))
                             + " degrees, four times the fall, dt 1e-5 s",
                         period, relative(1e-3), "s", source,
                         [angle = angle] { return periodOf(angle * degrees, 1e-5, 0); }});
    cases.push_back({"T-C3", "period from 10 degrees, 20 swings, dt 1/400 s", 2.01023589,
                     relative(1e-3), "s", source,
                     [] { return periodOf(10.0 * degrees, 1.0 / 400.0, 20); }});
    for (const double dt : {0.01, 0.005, 0.0025, 0.00125}) {
        char title[80];
        std::snprintf(title, sizeof title, "decay that projection causes from 10 degrees, dt %g s",
                      dt);
        cases.push_back({"T-C3", title, standardGravity * dt / 2.0, relative(0.1), "1/s",
                         "(g/L) dt / 2: zeta = w dt / 2, as implicit Euler",
                         [=] { return decayOf(dt); }});
    }
    return cases;
}

} // namespace ripstop
