// Particles on planes, spheres and cylinders: falling, resting, bouncing, sliding.
//
// In order: a fall of 1 m with and without rebounds (B1), ten seconds of rest on the ground (B2),
// slopes with friction (B3), and what each response leaves of a velocity, on planes, spheres and
// cylinders.
#include "assembly/finish.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace ripstop {
namespace {

// Explicit Euler falls half a step late by itself, so that the step in which it touches may be the
// next one.
constexpr std::array falling{Integrator::SemiImplicitEuler, Integrator::Verlet,
                             Integrator::VelocityVerlet, Integrator::Bdf2, Integrator::RungeKutta4};
constexpr std::array responses{Response::Stop, Response::Slide, Response::Contact};

Obstacle ground(Response response, double restitution = 0.0, double friction = 0.0)
{
    Obstacle obstacle{};
    obstacle.shape = ColliderShape::Plane;
    obstacle.position = Vec3::Zero();
    obstacle.normal = {0.0, 1.0, 0.0};
    obstacle.response = response;
    obstacle.restitution = restitution;
    obstacle.friction = friction;
    return obstacle;
}

Obstacle ball(Response response, double radius, double friction = 0.0)
{
    Obstacle obstacle = ground(response, 0.0, friction);
    obstacle.shape = ColliderShape::Sphere;
    obstacle.radius = radius;
    return obstacle;
}

// A cylinder that lies along z.
Obstacle drum(Response response, double radius, double length)
{
    Obstacle obstacle = ball(response, radius, 0.4);
    obstacle.shape = ColliderShape::Cylinder;
    obstacle.size = {0.0, length, 0.0};
    obstacle.turn << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    return obstacle;
}

// --- B1: a fall of 1 m ---------------------------------------------------------------------------

struct Fall
{
    double time = 0.0;  // s, of the first touch
    double speed = 0.0; // m/s, before it
    double left = 0.0;  // m/s, after it, with restitution 0
};

Fall fall(Integrator integrator)
{
    System system = heavySystem(1e-3, integrator);
    system.obstacles = {ground(Response::Contact)};
    addParticle(system, {0.0, 1.0, 0.0}, 1.0);
    finish(system);
    Stepper stepper;
    State state = system.start;
    Fall result;
    while (state.position[0].y() > 0.0 && state.time < 2.0) {
        result.speed = -state.velocity[0].y();
        stepper.step(system, state);
    }
    result.time = state.time;
    result.left = state.velocity[0].norm();
    return result;
}

struct Bounces
{
    std::array<double, 2> top{}; // m, of the first rebounds
    double end = 0.0;            // s, the last time that it was off the ground
};

Bounces bounces(Integrator integrator, double restitution, double total)
{
    System system = heavySystem(1e-4, integrator);
    system.obstacles = {ground(Response::Contact, restitution)};
    addParticle(system, {0.0, 1.0, 0.0}, 1.0);
    finish(system);
    Stepper stepper;
    State state = system.start;
    Bounces result;
    double before = 0.0;
    std::size_t tops = 0;
    while (state.time < total + 0.5) {
        stepper.step(system, state);
        const double v = state.velocity[0].y();
        if (before > 0.0 && v <= 0.0 && tops < 2)
            result.top[tops++] = state.position[0].y();
        before = v;
        if (state.position[0].y() > 1e-6)
            result.end = state.time;
    }
    return result;
}

void addDrops(std::vector<Case>& cases)
{
    for (const Integrator integrator : falling) {
        const auto drop = shared([=] { return fall(integrator); });
        const std::string by = ", fall of 1 m, dt 1 ms, " + nameOf(integrator);
        cases.push_back({"T-B1", "time of the impact" + by, 0.451601, within(1.001e-3), "s",
                         "sqrt(2 h / g); one step", [=] { return drop().time; }});
        cases.push_back({"T-B1", "speed before the impact" + by, 4.428691, within(0.02), "m/s",
                         "sqrt(2 g h); two steps of g dt", [=] { return drop().speed; }});
        cases.push_back({"T-B1", "speed after the impact, e = 0" + by, 0.0, within(1e-12), "m/s",
                         "inelastic", [=] { return drop().left; }});
        for (const auto& [e, total] : {std::pair(0.5, 1.354802), {0.8, 4.064407}}) {
            const auto play =
                shared([=, e = e, total = total] { return bounces(integrator, e, total); });
            std::string with = e == 0.5 ? ", e 0.5" : ", e 0.8";
            with += ", fall of 1 m, " + nameOf(integrator);
            cases.push_back({"T-B1", "first rebound" + with, e * e, relative(0.01), "m", "e^2 h",
                             [=] { return play().top[0]; }});
            cases.push_back({"T-B1", "second rebound" + with, e * e * e * e, relative(0.01), "m",
                             "e^4 h", [=] { return play().top[1]; }});
            // the last rebounds are shorter than a step, which cuts them off
            cases.push_back({"T-B1", "end of the bounces" + with, total, relative(0.03), "s",
                             "sqrt(2 h/g) (1 + e) / (1 - e)", [=] { return play().end; }});
        }
    }
}

// --- B2: ten seconds on the ground ---------------------------------------------------------------

double restlessness(Response response) // m, the largest way in any direction, of all integrators
{
    double most = 0.0;
    for (const Integrator integrator : allIntegrators) {
        System system = heavySystem(0.01, integrator);
        system.obstacles = {ground(response, 0.3, 0.5)};
        addParticle(system, {0.3, 0.0, -0.2}, 1.0);
        addParticle(system, {1.0, 1e-9, 0.0}, 0.001);
        addParticle(system, {2.0, -1e-9, 0.0}, 70.0);
        finish(system);
        Stepper stepper;
        State state = system.start;
        for (int i = 0; i < 1000; ++i) {
            stepper.step(system, state);
            for (std::size_t p = 0; p < 3; ++p)
                most = std::max(most, (state.position[p] - system.start.position[p]).norm());
        }
    }
    return most;
}

// --- B3: slopes ----------------------------------------------------------------------------------

struct Slide
{
    double way = 0.0;   // m, down a slope of 30 degrees
    double speed = 0.0; // m/s
};

Slide slide(Integrator integrator, double friction, int steps)
{
    const double angle = std::numbers::pi / 6.0;
    const Vec3 down(-std::cos(angle), -std::sin(angle), 0.0);
    System system = heavySystem(1e-3, integrator);
    system.obstacles = {ground(Response::Contact, 0.0, friction)};
    system.obstacles[0].normal = {-std::sin(angle), std::cos(angle), 0.0};
    addParticle(system, Vec3::Zero(), 2.0);
    finish(system);
    const State state = run(system, steps);
    return {down.dot(state.position[0]), down.dot(state.velocity[0])};
}

Slide slideToStop(Integrator integrator) // the way, and as speed the time at which it ends
{
    System system = heavySystem(1e-3, integrator);
    system.obstacles = {ground(Response::Contact, 0.0, 0.3)};
    addParticle(system, Vec3::Zero(), 1.0, {3.0, 0.0, 0.0});
    finish(system);
    Stepper stepper;
    State state = system.start;
    double stopped = 0.0;
    for (int i = 0; i < 2000; ++i) {
        stepper.step(system, state);
        if (state.velocity[0].x() > 1e-9) // not y, where gravity adds what contact takes
            stopped = state.time;
    }
    return {state.position[0].x(), stopped};
}

void addSlopes(std::vector<Case>& cases)
{
    for (const Integrator integrator : allIntegrators) {
        const std::string by = ", " + nameOf(integrator);
        cases.push_back({"T-B3", "slope of 30 degrees, mu 0.3, way in 2 s" + by, 2.0 * 2.355483,
                         relative(0.01), "m", "a t^2/2, a = g (sin - mu cos)",
                         [=] { return slide(integrator, 0.3, 2000).way; }});
        cases.push_back({"T-B3", "slope of 30 degrees, mu 0.3, speed after 2 s" + by,
                         2.0 * 2.355483, relative(0.01), "m/s", "a t, a = g (sin - mu cos)",
                         [=] { return slide(integrator, 0.3, 2000).speed; }});
        cases.push_back({"T-B3", "slope of 30 degrees, friction from which it sticks" + by,
                         0.577350, relative(0.01), "", "tan 30", [=] {
                             const auto slips = [=](double friction) {
                                 return slide(integrator, friction, 3000).way > 1e-3;
                             };
                             return limitOf(slips, 0.5, 0.65, 10);
                         }});
        cases.push_back({"T-B3", "slope of 30 degrees, mu 0.58, creep in 10 s" + by, 0.0,
                         within(1e-6), "m", "sticks",
                         [=] { return slide(integrator, 0.58, 10000).way; }});
        cases.push_back({"T-B3", "3 m/s on the level, mu 0.3, way" + by, 1.529574, relative(0.01),
                         "m", "v^2 / (2 mu g)", [=] { return slideToStop(integrator).way; }});
        cases.push_back({"T-B3", "3 m/s on the level, mu 0.3, time" + by, 1.019716, relative(0.01),
                         "s", "v / (mu g)", [=] { return slideToStop(integrator).speed; }});
    }
}

// --- spheres, and what each response leaves ------------------------------------------------------

double heightOn(const Obstacle& obstacle) // m, over the middle
{
    System system = heavySystem(1e-3);
    system.obstacles = {obstacle};
    addParticle(system, {0.0, 1.2 * obstacle.radius, 0.0}, 1.0);
    finish(system);
    return run(system, 2000).position[0].y();
}

Vec3 leftBy(Response response) // m/s, of 2 m/s into the floor and 5 m/s along it
{
    System system = emptySystem(0.01);
    system.obstacles = {ground(response, 0.5, 0.2)};
    addParticle(system, {0.0, 0.01, 0.0}, 1.0, {3.0, -2.0, 4.0});
    finish(system);
    return run(system, 1).velocity[0];
}

void addResponses(std::vector<Case>& cases)
{
    for (const Response response : responses) {
        const std::string by = ", " + nameOf(response);
        cases.push_back({"T-B2", "10 s of rest on a plane, largest way of all integrators" + by,
                         0.0, within(1e-6), "m", "rest", [=] { return restlessness(response); }});
        cases.push_back({"F15", "rest on top of a sphere of 1 m, height" + by, 1.0, relative(0.01),
                         "m", "R, and not sqrt(3) R (first paper)",
                         [=] { return heightOn(ball(response, 1.0, 0.4)); }});
        cases.push_back({"F15", "rest on top of a lying cylinder of 1 m, height" + by, 1.0,
                         within(1e-6), "m", "R",
                         [=] { return heightOn(drum(response, 1.0, 4.0)); }});
    }
    const struct
    {
        Response response;
        Vec3 left;
        const char* source;
    } obliques[] = {{Response::Stop, {0.0, 0.0, 0.0}, "nothing is left"},
                    {Response::Slide, {3.0, 0.0, 4.0}, "what goes along is left"},
                    // normal impulse (1 + 0.5) 2 = 3 m/s; friction 0.2 x 3 = 0.6 of 5 m/s along
                    {Response::Contact, {2.64, 1.0, 3.52}, "e v_n; v_t - mu (1 + e) v_n"}};
    for (const auto& oblique : obliques) {
        const std::string by = ", (3, -2, 4) m/s, e 0.5, mu 0.2, " + nameOf(oblique.response);
        for (const int axis : {0, 1, 2})
            cases.push_back({"F14",
                             std::string("oblique impact, speed left along ") + "xyz"[axis] + by,
                             oblique.left[axis], within(1e-12), "m/s", oblique.source,
                             [=, response = oblique.response] { return leftBy(response)[axis]; }});
    }
}

} // namespace

std::vector<Case> contactCases()
{
    std::vector<Case> cases;
    addDrops(cases);
    addSlopes(cases);
    addResponses(cases);
    return cases;
}

} // namespace ripstop
