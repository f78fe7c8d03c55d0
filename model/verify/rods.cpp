// One projection of rods, with nothing else done.
//
// In order: averaging as diffusion, mode by mode (K1); what a projection does to momentum and to
// the mass centre (K3 to K6); the order of rods; and degenerate rods, whose motion must be zero.
#include "assembly/finish.h"
#include "constraints/rod_solver.h"
#include "measure/diagnostics.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace ripstop {
namespace {

constexpr std::array averaging{Solver::AveragedJacobi, Solver::PaperJacobi};
constexpr std::array sweeping{Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel};
constexpr std::array conserving{Solver::AveragedJacobi, Solver::GaussSeidel, Solver::Direct};

// The positions of `system.start` after so many sweeps.
std::vector<PaddedVec3> projected(System system, Solver solver, int sweeps)
{
    system.solver = solver;
    system.sweeps = sweeps;
    finish(system);
    std::vector<double> restLength;
    for (const Rod& rod : system.rods)
        restLength.push_back(rod.restLength);
    std::vector<PaddedVec3> position = system.start.position;
    RodSolver rods;
    ThreadPool pool(1);
    const RodTask task{system,     solver, sweeps, {},      system.start.rodTorn,
                       restLength, 1.0,    0,      position};
    rods.start(task, system.start.rodTension);
    rods.project(task, pool);
    return position;
}

System chain(int nodes)
{
    System system = emptySystem(0.01);
    for (int i = 0; i < nodes; ++i) {
        addParticle(system, {1.0 * i, 0.0, 0.0}, 1.0);
        if (i > 0)
            addRod(system, i - 1, i, 1.0);
    }
    return system;
}

// 20 x 20 particles, 0.1 m apart, 760 structural rods and 361 diagonals, shaken by up to 2 cm.
System shakenCloth()
{
    System system = emptySystem(0.01);
    const int side = 20;
    Dice dice(7);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            addParticle(system, Vec3(0.1 * i, 0.0, 0.1 * j) + dice.vector(0.02), 1.0);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int here = j * side + i;
            if (i + 1 < side)
                addRod(system, here, here + 1, 0.1);
            if (j + 1 < side)
                addRod(system, here, here + side, 0.1);
            if (i + 1 < side && j + 1 < side)
                addRod(system, here, here + side + 1, 0.1 * std::sqrt(2.0));
        }
    return system;
}

// --- K1: averaging is diffusion ---------------------------------------------------------------

double slowest(double count) { return 1.0 - (1.0 - std::cos(std::numbers::pi / count)) / 2.0; }

// What a sweep leaves of the mode sin(pi (i - offset) / span), the worst node of the inner ones. A
// free chain goes on beyond the nodes of rest, so that no free end is felt within the sweeps.
double factorOf(Solver solver, int count, int sweeps, bool pinned)
{
    const int margin = pinned ? 0 : sweeps + 2;
    const double span = pinned ? count - 1.0 : count;
    const double offset = pinned ? 0.5 : 0.0;
    const auto mode = [&](int i) {
        return 1e-3 * std::sin(std::numbers::pi * (i - offset) / span);
    };
    System system = chain(count + 1 + 2 * margin);
    if (pinned)
        system.inverseMass.front() = system.inverseMass.back() = 0.0;
    for (int i = pinned ? 1 : 0; i < count + (pinned ? 0 : 1) + 2 * margin; ++i)
        system.start.position[std::size_t(i)].x() += mode(i - margin);
    const std::vector<PaddedVec3> after = projected(system, solver, sweeps);
    const double expected = slowest(span);
    double worst = expected;
    for (int i = 1; i < count; ++i) {
        const double left = after[std::size_t(i + margin)].x() - (i + margin);
        const double factor = std::pow(left / mode(i), 1.0 / sweeps);
        if (std::abs(factor - expected) > std::abs(worst - expected))
            worst = factor;
    }
    return worst;
}

void addDiffusion(std::vector<Case>& cases)
{
    for (const Solver solver : averaging) {
        for (const int count : {5, 14, 15, 30})
            cases.push_back({"T-K1",
                             "what a sweep leaves of the slowest mode, N " + std::to_string(count)
                                 + ", " + nameOf(solver),
                             slowest(count), within(1e-9), "", "1 - (1 - cos(pi/N)) / 2",
                             [=] { return factorOf(solver, count, 10, false); }});
        for (const int count : {5, 14, 30}) // a pinned end makes the last rod count half
            cases.push_back(
                {"T-K1",
                 "the same between two pins, N " + std::to_string(count) + ", " + nameOf(solver),
                 slowest(count - 1), within(1e-9), "", "1 - (1 - cos(pi/(N-1))) / 2",
                 [=] { return factorOf(solver, count, 10, true); }});
    }
    cases.push_back({"T-K1", "slowest mode left by the paper's 55 sweeps, N 14",
                     std::pow(slowest(14), 55), within(1e-9), "", "0.987464^55 = 0.5",
                     [] { return std::pow(factorOf(Solver::AveragedJacobi, 14, 55, false), 55); }});
}

// --- K3 to K6 ---------------------------------------------------------------------------------

double centerShift(const System& system, Solver solver, int sweeps) // m
{
    System counted = system;
    finish(counted);
    return (centerOfMass(counted, projected(system, solver, sweeps))
            - centerOfMass(counted, system.start.position))
        .norm();
}

void addMomentum(std::vector<Case>& cases)
{
    System path = emptySystem(0.01); // ab stretched by 0.3 m, bc as it should be
    for (const double x : {0.0, 1.3, 2.3})
        addParticle(path, {x, 0.0, 0.0}, 1.0);
    addRod(path, 0, 1, 1.0);
    addRod(path, 1, 2, 1.0);
    for (const int sweeps : {1, 55}) {
        const std::string after = " after " + std::to_string(sweeps) + " sweeps, ";
        cases.push_back(
            {"T-K3", "three-node path, centre of mass moves" + after + nameOf(Solver::PaperJacobi),
             0.025, within(1e-14), "m", "s / 12: figure 8 of the paper",
             [=] { return centerShift(path, Solver::PaperJacobi, sweeps); }});
        for (const Solver solver : conserving)
            cases.push_back({"T-K3",
                             "three-node path, centre of mass moves" + after + nameOf(solver), 0.0,
                             within(1e-14), "m", "momentum (Tonge 2012)",
                             [=] { return centerShift(path, solver, sweeps); }});
    }
    for (const Solver solver : conserving)
        cases.push_back({"T-K3", "shaken net of 1121 rods, centre of mass moves, " + nameOf(solver),
                         0.0, within(1e-14), "m", "momentum; 55 sweeps", [=] {
                             System net = shakenCloth();
                             for (std::size_t i = 0; i < net.mass.size(); ++i) {
                                 net.mass[i] = 0.5 + 0.01 * double(i % 37);
                                 net.inverseMass[i] = 1.0 / net.mass[i];
                             }
                             return centerShift(net, solver, 55);
                         }});
}

// Averaging does not mind in what order the 1121 rods come.
double orderGap(Solver solver)
{
    System system = shakenCloth();
    const std::vector<PaddedVec3> first = projected(system, solver, 55);
    Dice dice(3);
    double gap = 0.0;
    for (int shuffle = 0; shuffle < 3; ++shuffle) {
        for (std::size_t i = system.rods.size(); i > 1; --i)
            std::swap(system.rods[i - 1], system.rods[std::size_t(dice.below(int(i)))]);
        const std::vector<PaddedVec3> other = projected(system, solver, 55);
        for (std::size_t i = 0; i < first.size(); ++i)
            gap = std::max(gap, (other[i] - first[i]).norm());
    }
    return gap;
}

// Coincident ends, a particle without rods, two pins, two pins at one place; the largest motion,
// speed or tension in 20 steps of each integrator.
double degenerateMotion(Solver solver)
{
    System system = emptySystem(0.01);
    addParticle(system, {1.0, 1.0, 1.0}, 1.0); // 0 and 1 coincide
    addParticle(system, {1.0, 1.0, 1.0}, 1.0);
    addRod(system, 0, 1, 0.5);
    addParticle(system, {4.0, 0.0, 0.0}, 1.0); // 2 has no rods
    addPin(system, {5.0, 0.0, 0.0});           // 3 and 4 are pins, 1 m apart
    addPin(system, {6.0, 0.0, 0.0});
    addRod(system, 3, 4, 0.5);
    addPin(system, {6.0, 0.0, 0.0}); // 5 is a pin at the place of 4
    addRod(system, 4, 5, 0.5);
    addRod(system, 4, 5, 0.0);
    system.solver = solver;
    finish(system);
    double most = 0.0;
    const auto note = [&](double size) { // a NaN is noted, too, and stays
        if (!(size <= most) && most == most)
            most = size;
    };
    for (const Integrator integrator : allIntegrators) {
        system.integrator = integrator;
        const State after = run(system, 20);
        for (std::size_t i = 0; i < after.position.size(); ++i) {
            note((after.position[i] - system.start.position[i]).norm());
            note(after.velocity[i].norm());
        }
        for (const double tension : after.rodTension)
            note(std::abs(tension));
    }
    return most;
}

void addPairs(std::vector<Case>& cases)
{
    for (const Solver solver : averaging)
        cases.push_back({"T-K4",
                         "1121 rods in another order, largest difference, " + nameOf(solver), 0.0,
                         within(1e-14), "m", "averages have no order; 55 sweeps",
                         [=] { return orderGap(solver); }});
    System pair = emptySystem(0.01);
    addParticle(pair, Vec3::Zero(), 1.0);
    addParticle(pair, {1.2, 0.0, 0.0}, 3.0);
    addRod(pair, 0, 1, 1.0);
    for (const Solver solver : sweeping) {
        cases.push_back({"T-K5", "rod between 1 and 3 kg, 1 kg moves, " + nameOf(solver), 0.15,
                         within(1e-14), "m", "3 s / 4",
                         [=] { return projected(pair, solver, 1)[0].x(); }});
        cases.push_back({"T-K5", "rod between 1 and 3 kg, 3 kg moves, " + nameOf(solver), -0.05,
                         within(1e-14), "m", "-s / 4",
                         [=] { return projected(pair, solver, 1)[1].x() - 1.2; }});
    }
    for (const Solver solver :
         {Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel, Solver::Direct})
        cases.push_back({"T-K6", "degenerate rods, largest motion, " + nameOf(solver), 0.0, exactly,
                         "", "no direction, no motion, no NaN",
                         [=] { return degenerateMotion(solver); }});
}

} // namespace

std::vector<Case> rodCases()
{
    std::vector<Case> cases;
    addDiffusion(cases);
    addMomentum(cases);
    addPairs(cases);
    return cases;
}

} // namespace ripstop
