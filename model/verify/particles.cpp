// Single particles and flat plates against closed forms: weight, drag, wind.
//
// In order: projectiles and constant forces, where the schemes have known errors; plates that fall
// to their terminal velocity; plates that are braked by drag; and plates that drift with the wind.
#include "assembly/finish.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

// They are right about any parabola.
constexpr std::array exactOnParabolas{Integrator::Verlet, Integrator::VelocityVerlet,
                                      Integrator::RungeKutta4};

double orderOf(Integrator integrator)
{
    if (integrator == Integrator::RungeKutta4)
        return 4.0;
    return looksBack(integrator) ? 2.0 : 1.0;
}

// A triangle of three free particles that lies across `across`, so that it moves along it without
// turning: the load is spread over the corners in equal parts. 0.5 m^2.
System flatTriangle(double timeStep, Integrator integrator, double mass, double coefficient,
                    const Vec3& across)
{
    System system = emptySystem(timeStep, integrator);
    const Vec3 u = across.unitOrthogonal();
    const Vec3 v = across.cross(u);
    addParticle(system, Vec3::Zero(), mass / 3.0);
    addParticle(system, u, mass / 3.0);
    addParticle(system, v, mass / 3.0);
    addPanel(system, 0, 1, 2, AirLaw::Paper, coefficient);
    return system;
}

// --- projectiles ------------------------------------------------------------------------------

State thrown(Integrator integrator, double timeStep, int steps)
{
    System system = heavySystem(timeStep, integrator);
    const double speed = 20.0 * std::sqrt(0.5);
    addParticle(system, Vec3::Zero(), 1.0, {speed, speed, 0.0});
    finish(system);
    return run(system, steps);
}

void addProjectiles(std::vector<Case>& cases)
{
    const double flight = 20.0 * std::sqrt(2.0) / standardGravity; // 2.88419300 s
    const int steps = 288;
    for (const Integrator integrator : exactOnParabolas) {
        const std::string by = ", " + nameOf(integrator);
        cases.push_back({"T-P1", "20 m/s at 45 degrees, range" + by, 400.0 / standardGravity,
                         relative(1e-12), "m", "v^2 / g = 40.78864852 m", [=] {
                             return thrown(integrator, flight / steps, steps).position[0].x();
                         }});
        cases.push_back({"T-P1", "20 m/s at 45 degrees, apex" + by, 100.0 / standardGravity,
                         relative(1e-12), "m", "v^2 / 4 g = 10.19716213 m", [=] {
                             return thrown(integrator, flight / steps, steps / 2).position[0].y();
                         }});
        cases.push_back({"T-P1", "20 m/s at 45 degrees, height at landing" + by, 0.0, within(1e-11),
                         "m", "0 after 2 v sin 45 / g = 2.88419300 s", [=] {
                             return thrown(integrator, flight / steps, steps).position[0].y();
                         }});
    }
    // summing n steps by hand, the Euler schemes end g t dt / 2 too low or too high
    for (const double side : {-1.0, 1.0}) {
        const Integrator integrator =
            side < 0.0 ? Integrator::SemiImplicitEuler : Integrator::ExplicitEuler;
        cases.push_back({"T-P1", "error in height at 2 s, dt 0.01 s, " + nameOf(integrator),
                         side * 0.0980665, within(1e-9), "m", "g t dt / 2", [=] {
                             const double exact =
                                 40.0 * std::sqrt(0.5) - 0.5 * standardGravity * 4.0;
                             return thrown(integrator, 0.01, 200).position[0].y() - exact;
                         }});
    }
}

void addConstantForce(std::vector<Case>& cases)
{
    const Vec3 p0(1.0, -2.0, 0.5);
    const Vec3 v0(3.0, 1.0, -4.0);
    const Vec3 a(0.5, -1.0, 2.0);
    const double t = 3.0;
    const auto end = [=](Integrator integrator) {
        System system = emptySystem(0.01, integrator);
        system.gravity = a;
        addParticle(system, p0, 2.5, v0);
        finish(system);
        return Vec3(run(system, 300).position[0]);
    };
    const Vec3 exact = p0 + v0 * t + 0.5 * t * t * a;
    for (const Integrator integrator : exactOnParabolas) {
        cases.push_back({"T-P2",
                         "constant force for 3 s, distance to theory, " + nameOf(integrator), 0.0,
                         within(1e-12 * exact.norm()), "m", "p + v t + a t^2 / 2",
                         [=] { return (end(integrator) - exact).norm(); }});
        cases.push_back(
            {"T-P2", "distance to the paper's equation 1, which lacks a v, " + nameOf(integrator),
             (0.5 * t * v0).norm(), within(1e-11), "m", "v t / 2",
             [=] { return (end(integrator) - (p0 + 0.5 * t * (v0 + t * a))).norm(); }});
    }
    for (const Integrator integrator : allIntegrators)
        cases.push_back({"T-P3", "0.1, 1 and 60 kg fall alike for 2 s, " + nameOf(integrator), 0.0,
                         within(2e-14), "m", "Galilei; 1e-15 of the way", [=] {
                             System system = heavySystem(0.01, integrator);
                             for (const double mass : {0.1, 1.0, 60.0})
                                 addParticle(system, Vec3::Zero(), mass);
                             finish(system);
                             const State after = run(system, 200);
                             return std::max((after.position[1] - after.position[0]).norm(),
                                             (after.position[2] - after.position[0]).norm());
                         }});
}

// --- drag -------------------------------------------------------------------------------------

constexpr double terminal = 5.294; // m/s

System fallingPlate(Integrator integrator, double timeStep)
{
    const double mass = airDensity * 2.0 * 0.5 * terminal * terminal / (2.0 * standardGravity);
    System system = flatTriangle(timeStep, integrator, mass, 2.0, Vec3(0.0, 1.0, 0.0));
    system.gravity = {0.0, -standardGravity, 0.0};
    finish(system);
    return system;
}

double fallenBy(double time) // m
{
    return terminal * terminal / standardGravity
           * std::log(std::cosh(standardGravity * time / terminal));
}

double fallOrder(Integrator integrator)
{
    double error[2];
    for (const int refined : {0, 1}) {
        // what is of fourth order soon has no error but that of rounding
        const int perSecond = (integrator == Integrator::RungeKutta4 ? 50 : 1000) << refined;
        const State end = run(fallingPlate(integrator, 1.0 / perSecond), perSecond);
        error[refined] = std::abs(-end.position[0].y() - fallenBy(1.0));
    }
    return std::log2(error[0] / error[1]);
}

double ninetyPercentAfter() // s
{
    const System system = fallingPlate(Integrator::VelocityVerlet, 1e-4);
    Stepper stepper;
    State state = system.start;
    double before = 0.0;
    while (-state.velocity[0].y() < 0.9 * terminal && state.time < 10.0) {
        before = -state.velocity[0].y();
        stepper.step(system, state);
    }
    const double after = -state.velocity[0].y();
    return state.time - system.timeStep * (after - 0.9 * terminal) / (after - before);
}

void addFalls(std::vector<Case>& cases)
{
    const auto fall = shared([] {
        const System system = fallingPlate(Integrator::VelocityVerlet, 1e-4);
        const State one = run(system, 10000);
        return std::array{one, run(system, one, 10000)};
    });
    const double expected[][2] = {{5.039741, 3.382521}, {5.287594, 8.608784}};
    for (const std::size_t i : {0u, 1u}) {
        const std::string at = " at " + std::to_string(i + 1) + " s, terminal speed 5.294 m/s";
        cases.push_back({"T-P4", "fall against drag, speed" + at, expected[i][0], within(1e-6),
                         "m/s", "vt tanh(g t / vt)", [=] { return -fall()[i].velocity[0].y(); }});
        cases.push_back({"T-P4", "fall against drag, way" + at, expected[i][1], within(1e-6), "m",
                         "vt^2/g ln cosh(g t / vt)", [=] { return -fall()[i].position[0].y(); }});
    }
    cases.push_back({"T-P4", "fall against drag, time to 90 % of the terminal speed", 0.79476,
                     within(5e-6), "s", "vt/g artanh 0.9", ninetyPercentAfter});
    for (const Integrator integrator : allIntegrators)
        cases.push_back({"T-P4", "fall against drag, order of the error, " + nameOf(integrator),
                         orderOf(integrator), within(0.1), "", "order of the scheme",
                         [=] { return fallOrder(integrator); }});
}

// A plate of 0.2 kg that flies broadside at 8 m/s in calm air, C = 1.2: its speed falls to
// v0 / (1 + v0 t / lam), lam = 2 m / (rho C A).
void addBraking(std::vector<Case>& cases)
{
    const double length = 2.0 * 0.2 / (airDensity * 1.2 * 0.5); // m
    const auto braked = [](Integrator integrator, double timeStep) {
        System system = flatTriangle(timeStep, integrator, 0.2, 1.2, Vec3(1.0, 0.0, 0.0));
        for (auto& velocity : system.start.velocity)
            velocity = Vec3(8.0, 0.0, 0.0);
        finish(system);
        return system;
    };
    cases.push_back({"T-P5", "plate brakes from 8 m/s, speed after 1 s", 8.0 / (1.0 + 8.0 / length),
                     relative(1e-6), "m/s", "v / (1 + v t / lam)", [=] {
                         const System system = braked(Integrator::VelocityVerlet, 2.5e-4);
                         return run(system, 4000).velocity[0].x();
                     }});
    cases.push_back({"T-P5", "plate brakes with dt = 0.9 lam / v, lowest speed", 0.0, atLeast,
                     "m/s", "no overshoot below lam / v", [=] {
                         const System system =
                             braked(Integrator::SemiImplicitEuler, 0.9 * length / 8.0);
                         Stepper stepper;
                         State state = system.start;
                         double lowest = 8.0;
                         for (int i = 0; i < 200; ++i) {
                             stepper.step(system, state);
                             lowest = std::min(lowest, state.velocity[0].x());
                         }
                         return lowest;
                     }});
}

// Released at rest in wind W, a plate drifts W t - lam ln(1 + W t / lam).
void addDrifts(std::vector<Case>& cases)
{
    const double length = 2.0 * 0.2 / (airDensity * 1.2 * 0.5);        // m
    const double drifts[][2] = {{2.0, 3.0}, {12.0, 1.0}, {-6.0, 2.0}}; // m/s, s
    for (const auto& [wind, time] : drifts) {
        const auto drift = [wind = wind, time = time] {
            const int steps = 4000;
            System system = flatTriangle(time / steps, Integrator::VelocityVerlet, 0.2, 1.2,
                                         Vec3(1.0, 0.0, 0.0));
            system.wind = {wind, 0.0, 0.0};
            finish(system);
            return run(system, steps);
        };
        char name[60];
        std::snprintf(name, sizeof name, "%g s in a wind of %g m/s, ", time, wind);
        const double way = std::abs(wind) * time;
        const double sign = wind < 0.0 ? -1.0 : 1.0;
        cases.push_back({"T-P6", name + std::string("drift"),
                         sign * (way - length * std::log1p(way / length)), relative(1e-6), "m",
                         "W t - lam ln(1 + W t / lam)", [=] { return drift().position[0].x(); }});
        cases.push_back({"T-P6", name + std::string("speed"), wind - wind / (1.0 + way / length),
                         relative(1e-6), "m/s", "W - W / (1 + W t / lam)",
                         [=] { return drift().velocity[0].x(); }});
    }
}

} // namespace

std::vector<Case> particleCases()
{
    std::vector<Case> cases;
    addProjectiles(cases);
    addConstantForce(cases);
    addFalls(cases);
    addBraking(cases);
    addDrifts(cases);
    return cases;
}

} // namespace ripstop
