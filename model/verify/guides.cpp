// Particles that are free along a line only: a bead, a pendulum on a trolley, an ellipse trammel.
//
// In order: a bead on a wire that leans (K8), a pendulum whose pivot rolls on a rail (K9), and a
// rod between beads on crossed wires, whose loss of energy is that of projection (K10).
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;

int addBead(System& system, const Vec3& position, double mass, const Vec3& axis,
            const Vec3& velocity = Vec3::Zero())
{
    const int particle = addParticle(system, position, mass, velocity);
    system.guided.push_back({particle, Guide::Line, axis});
    return particle;
}

// Speed after a second on a wire that leans by 30 degrees.
double slidingSpeed(Integrator integrator)
{
    const Vec3 down(std::cos(pi / 6.0), -std::sin(pi / 6.0), 0.0);
    System system = heavySystem(1e-3, integrator);
    addBead(system, Vec3::Zero(), 0.3, down);
    finish(system);
    return run(system, 1000).velocity[0].norm();
}

// Mean of four periods of a bob under a trolley on a level rail, from 1 degree.
double trolleyPeriod(Solver solver, double bobOverTrolley)
{
    const double angle = pi / 180.0;
    System system = heavySystem(1.0 / 2000.0);
    system.solver = solver;
    addBead(system, Vec3::Zero(), 1.0, Vec3::UnitX());
    addParticle(system, {std::sin(angle), -std::cos(angle), 0.0}, bobOverTrolley);
    addRod(system, 0, 1, 1.0);
    finish(system);
    Stepper stepper;
    State state = system.start;
    double first = 0.0, before = 1.0;
    for (int crossings = 0; state.time < 30.0;) {
        stepper.step(system, state);
        const double now = state.position[1].x() - state.position[0].x();
        if ((now > 0.0) != (before > 0.0)) {
            const double time = state.time - system.timeStep * now / (now - before);
            if (crossings == 0)
                first = time;
            if (crossings++ == 8)
                return (time - first) / 4.0;
        }
        before = now;
    }
    return 0.0;
}

// The share of their energy that one turn takes from two beads on crossed wires, joined by a rod of
// 0.5 m.
double trammelLoss(double h)
{
    const double rate = 2.0 * pi, length = 0.5;
    System system = emptySystem(h);
    system.solver = Solver::GaussSeidel;
    addBead(system, {length, 0.0, 0.0}, 0.2, Vec3::UnitX());
    addBead(system, Vec3::Zero(), 0.2, Vec3::UnitY(), {0.0, length * rate, 0.0});
    addRod(system, 0, 1, length);
    finish(system);
    const State state = run(system, int(std::lround(1.0 / h)));
    return 1.0 - kineticEnergy(system, state) / kineticEnergy(system, system.start);
}

} // namespace

std::vector<Case> guideCases()
{
    std::vector<Case> cases;
    for (std::size_t i = 0; i < choiceNames<Integrator>.size(); ++i)
        cases.push_back({"T-K8",
                         "bead on a wire at 30 degrees, speed after 1 s, "
                             + std::string(choiceNames<Integrator>[i]),
                         0.5 * standardGravity, relative(1e-9), "m/s", "g sin(angle) t",
                         [=] { return slidingSpeed(Integrator(i)); }});
    for (const Solver solver : {Solver::AveragedJacobi, Solver::GaussSeidel, Solver::Direct})
        for (const double ratio : {0.5, 4.0}) {
            char title[100];
            std::snprintf(title, sizeof title, "pendulum on a trolley, bob / trolley %g, %s", ratio,
                          choiceNames<Solver>[std::size_t(solver)].data());
            cases.push_back({"T-K9", title, 2.0 * pi / std::sqrt(standardGravity * (1.0 + ratio)),
                             relative(1e-3), "s", "2 pi / sqrt(g / L (1 + m / M))",
                             [=] { return trolleyPeriod(solver, ratio); }});
        }
    for (const double h : {1e-3, 1e-4}) {
        char title[100];
        std::snprintf(title, sizeof title, "ellipse trammel, energy lost in a turn, dt %g s", h);
        // a turn of 1 s at 2 pi rad/s; more of the small angles count where the step is long
        cases.push_back({"T-K10", title, 8.0 * pi * pi * h, relative(0.15), "",
                         "2 w^2 dt T, as a "
                         "circular motion loses to projection",
                         [=] { return trammelLoss(h); }});
    }
    return cases;
}

} // namespace ripstop
