// What no choice of frame, mirror or winding may change, and what a free object keeps.
//
// In order: the same patch in another frame (C5 to C7), forces inside a network, which must cancel
// (C1), momentum and angular momentum of a free object (C2), and the order of the whole step (C8).
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <optional>

namespace ripstop {
namespace {

// How the patch is held together: by rods and their solver, or by springs where there is no solver.
using Ties = std::optional<Solver>;
const std::array<Ties, 4> allTies{Ties(), Ties(Solver::AveragedJacobi), Ties(Solver::GaussSeidel),
                                  Ties(Solver::Direct)};

std::string nameOfTies(const Ties& ties)
{
    return ties ? "rods, " + nameOf(*ties) : std::string("springs");
}

// A patch of 5 x 5 particles, 0.1 m apart and a little bent, with fabric on it, in a light wind:
// smooth enough for trajectories to be compared after a second.
System patch(Integrator integrator, const Ties& ties, bool pinned)
{
    System system = heavySystem(1.0 / 500.0, integrator);
    system.solver = ties.value_or(Solver::GaussSeidel);
    system.sweeps = 12;
    system.wind = {0.5, 0.2, 0.8};
    const int side = 5;
    const auto at = [&](int i, int j) { return j * side + i; };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const Vec3 place(0.1 * i, -0.1 * j, 0.02 * std::sin(0.9 * i) * std::cos(0.7 * j));
            if (pinned && j == 0 && (i == 0 || i == side - 1))
                addPin(system, place, 0.02);
            else
                addParticle(system, place, 0.02 + 0.001 * i, {0.02 * j, 0.0, 0.03 * i});
        }
    const auto tie = [&](int a, int b) {
        const double length = distance(system, a, b);
        if (ties)
            addRod(system, a, b, length);
        else
            addSpring(system, a, b, length, 60.0, 0.05);
    };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            if (i + 1 < side)
                tie(at(i, j), at(i + 1, j));
            if (j + 1 < side)
                tie(at(i, j), at(i, j + 1));
            if (i + 1 < side && j + 1 < side) {
                tie(at(i, j), at(i + 1, j + 1));
                addPanel(system, at(i, j), at(i, j + 1), at(i + 1, j + 1), AirLaw::LinearNormal,
                         1.5, 0.02);
                addPanel(system, at(i, j), at(i + 1, j + 1), at(i + 1, j), AirLaw::Paper, 1.5,
                         0.02);
            }
        }
    return system;
}

// --- C5 to C7: another frame ---------------------------------------------------------------------

// The patch of patch() seen from another frame; place() is where a particle should be at a time.
struct OtherFrame
{
    const char* id;
    const char* title;
    double tolerance; // m, after one second
    bool pinned;
    void (*change)(System&);
    Vec3 (*place)(const Vec3&, double time);
};

const Vec3 shift(1e3, -2e3, 5e2);
const Vec3 boost(0.7, -0.3, 1.1); // a walk, so that round-off far out stays below the tolerance

Eigen::Matrix3d turn()
{
    return Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
}

Vec3 mirror(const Vec3& x) { return {-x.x(), x.y(), x.z()}; }

template <typename Map>
void mapMotion(System& system, const Map& map)
{
    for (auto* vectors : {&system.start.position, &system.start.velocity})
        for (auto& vector : *vectors)
            vector = Vec3(map(vector));
}

const OtherFrame frames[] = {
    {"T-C5", "moved by (1000, -2000, 500) m", 1e-7, true,
     [](System& system) {
         for (auto& x : system.start.position)
             x += shift;
     },
     [](const Vec3& x, double) { return Vec3(x + shift); }},
    {"T-C5", "turned by 1.1 rad", 1e-7, true,
     [](System& system) {
         mapMotion(system, [](const Vec3& x) { return Vec3(turn() * x); });
         system.gravity = turn() * system.gravity;
         system.wind = turn() * system.wind;
     },
     [](const Vec3& x, double) { return Vec3(turn() * x); }},
    {"T-C6", "on a train of (0.7, -0.3, 1.1) m/s", 1e-9, false,
     [](System& system) {
         for (auto& v : system.start.velocity)
             v += boost;
         system.wind += boost;
     },
     [](const Vec3& x, double time) { return Vec3(x + time * boost); }},
    {"T-C7", "mirrored", 1e-12, true,
     [](System& system) {
         mapMotion(system, mirror);
         system.wind = mirror(system.wind);
     },
     [](const Vec3& x, double) { return mirror(x); }},
    {"T-C7", "corners of panels the other way round", 1e-9, true,
     [](System& system) {
         for (FabricPanel& panel : system.panels)
             std::swap(panel.corner[1], panel.corner[2]);
     },
     [](const Vec3& x, double) { return x; }},
};

double gapOf(const OtherFrame& frame, const Ties& ties) // m, the largest of all integrators
{
    double most = 0.0;
    for (const Integrator integrator : allIntegrators) {
        System here = patch(integrator, ties, frame.pinned);
        System there = here;
        frame.change(there);
        finish(here);
        finish(there);
        // BDF2 damps less, so that what differs by rounding grows by a few hundred in a second
        const int steps = integrator == Integrator::Bdf2 ? 250 : 500;
        const State a = run(here, steps);
        const State b = run(there, steps);
        for (std::size_t i = 0; i < a.position.size(); ++i)
            most = std::max(most, (frame.place(a.position[i], a.time) - b.position[i]).norm());
    }
    return most;
}

void addFrames(std::vector<Case>& cases)
{
    for (const OtherFrame& frame : frames)
        for (const Ties& ties : allTies)
            cases.push_back({frame.id,
                             std::string("cloth in wind, ") + frame.title
                                 + ", gap after 1 s (bdf2 0.5 s), all integrators, "
                                 + nameOfTies(ties),
                             0.0, within(frame.tolerance), "m", "invariance",
                             [&frame, ties] { return gapOf(frame, ties); }});
}

// --- C1: forces inside ---------------------------------------------------------------------------

struct Inside
{
    double force;  // 1, of the sum of sizes
    double moment; // m, of the sum of sizes of forces
};

// Springs and dampers on a random network, read from one explicit step of a second.
Inside inside(double stiffness, double damping)
{
    Dice dice(1);
    System system = emptySystem(1.0, Integrator::ExplicitEuler);
    for (int i = 0; i < 60; ++i) {
        const Vec3 place = dice.vector(1.0);
        const Vec3 velocity = dice.vector(1.0);
        addParticle(system, place, dice(0.5, 2.0), velocity);
    }
    for (int i = 0; i < 200; ++i) {
        const int a = dice.below(60);
        const int b = (a + 1 + dice.below(59)) % 60;
        addSpring(system, a, b, 0.7, stiffness, damping);
    }
    finish(system);
    const State after = run(system, 1);
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double sum = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
        const Vec3 f = system.mass[i] * (after.velocity[i] - system.start.velocity[i]);
        force += f;
        moment += system.start.position[i].cross(f);
        sum += f.norm();
    }
    return {force.norm() / sum, moment.norm() / sum};
}

void addInside(std::vector<Case>& cases)
{
    const struct
    {
        const char* title;
        double stiffness, damping;
    } kinds[] = {
        {"200 springs", 50.0, 0.0}, {"200 dampers", 0.0, 3.0}, {"200 damped springs", 50.0, 3.0}};
    for (const auto& kind : kinds) {
        const auto sums = shared([=] { return inside(kind.stiffness, kind.damping); });
        cases.push_back({"T-C1", std::string("sum of forces over their sizes, ") + kind.title, 0.0,
                         within(1e-12), "", "action and reaction", [=] { return sums().force; }});
        cases.push_back({"T-C1", std::string("sum of moments over the forces, ") + kind.title, 0.0,
                         within(1e-12), "m", "forces along the links",
                         [=] { return sums().moment; }});
    }
}

// --- C2: a free object ---------------------------------------------------------------------------

Vec3 angularMomentum(const System& system, const State& state)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < state.position.size(); ++i)
        sum += system.mass[i] * Vec3(state.position[i]).cross(state.velocity[i]);
    return sum;
}

struct Kept
{
    double momentum = 0.0; // kg m/s, change
    double center = 0.0;   // m, off its straight way
    double angular = 0.0;  // kg m^2/s, change
};

// Explicit Euler moves x by the old velocity, so that x and F are no longer on one line: it is
// left out. Verlet keeps the moment of x(n) - x(n-1), which is what it remembers.
Kept kept(const Ties& ties)
{
    Kept most;
    for (const Integrator integrator :
         {Integrator::SemiImplicitEuler, Integrator::Verlet, Integrator::VelocityVerlet}) {
        System system = patch(integrator, ties, false);
        system.gravity.setZero();
        system.airDensity = 0.0;
        finish(system);
        State after = run(system, 500);
        const Vec3 p = momentum(system, system.start);
        const Vec3 center =
            centerOfMass(system, system.start.position) + after.time * p / totalMass(system);
        most.momentum = std::max(most.momentum, (momentum(system, after) - p).norm());
        most.center = std::max(most.center, (centerOfMass(system, after.position) - center).norm());
        if (integrator == Integrator::Verlet)
            after.velocity = after.drift;
        const Vec3 l = angularMomentum(system, system.start);
        most.angular = std::max(most.angular, (angularMomentum(system, after) - l).norm());
    }
    return most;
}

void addFree(std::vector<Case>& cases)
{
    for (const Ties& ties : allTies) {
        const auto change = shared([=] { return kept(ties); });
        const std::string by = ", cloth in vacuum for 1 s, " + nameOfTies(ties);
        cases.push_back({"T-C2", "change of momentum" + by, 0.0, within(1e-12), "kg m/s",
                         "no force from outside", [=] { return change().momentum; }});
        cases.push_back({"T-C2", "centre of mass off its way" + by, 0.0, within(1e-12), "m",
                         "no force from outside", [=] { return change().center; }});
        if (!ties)
            cases.push_back({"T-C2", "change of angular momentum" + by, 0.0, within(1e-9),
                             "kg m2/s", "forces along the links",
                             [=] { return change().angular; }});
    }
}

// --- C8: order of the whole step -----------------------------------------------------------------

// The order of convergence, from the differences between runs of 0.2 s with dt, dt/2 and dt/4.
double orderOf(Integrator integrator, const Ties& ties)
{
    std::vector<State> runs;
    for (const int refined : {0, 1, 2}) {
        System system = patch(integrator, ties, true);
        system.timeStep = 1.0 / (2000 << refined);
        finish(system);
        runs.push_back(run(system, 400 << refined));
    }
    double gap[2] = {0.0, 0.0};
    for (std::size_t i = 0; i < runs[0].position.size(); ++i)
        for (const std::size_t k : {0u, 1u})
            gap[k] += (runs[k + 1].position[i] - runs[k].position[i]).squaredNorm();
    return 0.5 * std::log2(gap[0] / gap[1]);
}

void addOrders(std::vector<Case>& cases)
{
    const std::string title = "cloth in wind, order of the step, ";
    cases.push_back({"T-C8", title + "springs, velocity_verlet", 2.0, within(0.1), "",
                     "order of the scheme",
                     [] { return orderOf(Integrator::VelocityVerlet, Ties()); }});
    cases.push_back({"T-C8", title + "springs, semi_implicit_euler", 1.0, within(0.1), "",
                     "order of the scheme",
                     [] { return orderOf(Integrator::SemiImplicitEuler, Ties()); }});
    cases.push_back({"T-C8", title + "rods, direct", 1.0, within(0.1), "",
                     "projection is of first order",
                     [] { return orderOf(Integrator::SemiImplicitEuler, Ties(Solver::Direct)); }});
}

} // namespace

std::vector<Case> invarianceCases()
{
    std::vector<Case> cases;
    addInside(cases);
    addFree(cases);
    addFrames(cases);
    addOrders(cases);
    return cases;
}

} // namespace ripstop
