// Weights that hang on rods: how far they come down and what the rods carry.
//
// First the elongation of ropes of many rods under the solvers, in percent, beside what is
// published; then the tensions that rods report, which must carry the weight below them.
#include "assembly/finish.h"
#include "measure/diagnostics.h"
#include "verify/by_default.h"

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

// Between neighbours; twice; and once more from each node to the one after the next.
enum class Neighbours { Single, Double, SecondNeighbours };

// A rope of N rods, 14 m in all, node mass 1 kg.
struct Hang
{
    Solver solver;
    int count;
    double load; // in node masses
    int sweeps;
    double timeStep; // s
    double percent;  // elongation, as published
    Neighbours ties = Neighbours::Single;
};

double elongation(const Hang& hang) // percent, steady
{
    System system = heavySystem(hang.timeStep, Integrator::Verlet);
    system.solver = hang.solver;
    system.sweeps = hang.sweeps;
    const double length = 14.0 / hang.count;
    addPin(system, Vec3::Zero());
    for (int i = 1; i <= hang.count; ++i) {
        addParticle(system, {0.0, -length * i, 0.0}, i == hang.count ? hang.load : 1.0);
        addRod(system, i - 1, i, length);
        if (hang.ties == Neighbours::Double)
            addRod(system, i - 1, i, length);
        if (hang.ties == Neighbours::SecondNeighbours && i > 1)
            addRod(system, i - 2, i, 2.0 * length);
    }
    finish(system);
    Stepper stepper;
    State state = system.start;
    double before = 0.0;
    for (int i = 0; i < 20000; ++i) {
        stepper.step(system, state);
        if (i % 500 == 499) {
            const double now = state.position.back().y();
            if (std::abs(now - before) < 1e-9)
                break;
            before = now;
        }
    }
    return 100.0 * (-state.position.back().y() / 14.0 - 1.0);
}

void addElongations(std::vector<Case>& cases)
{
    const Solver paper = Solver::PaperJacobi;
    const Solver split = Solver::AveragedJacobi;
    const Hang hangs[] = {
        {paper, 14, 1, 10, 0.01, 0.252},
        {paper, 14, 10, 55, 0.01, 0.073},
        {paper, 14, 60, 40, 0.01, 0.329},
        {paper, 14, 60, 55, 0.01, 0.238},
        {paper, 14, 60, 200, 0.01, 0.063},
        {split, 14, 1, 10, 0.01, 0.270},
        {split, 14, 1, 55, 0.01, 0.046},
        {split, 14, 10, 55, 0.01, 0.106},
        {split, 14, 60, 40, 0.01, 0.602},
        {split, 14, 60, 55, 0.01, 0.437},
        {split, 14, 60, 200, 0.01, 0.118},
        {paper, 14, 1, 55, 0.02, 0.1717},
        {paper, 14, 1, 55, 0.01, 0.0429},
        {paper, 14, 1, 55, 0.005, 0.0107},
        {paper, 14, 1, 55, 0.0025, 0.0027},
        {paper, 7, 1, 55, 0.01, 0.0072},
        {paper, 28, 1, 55, 0.01, 0.1891},
        {paper, 56, 1, 55, 0.01, 0.7811},
        {paper, 14, 1, 10, 0.01, 0.252, Neighbours::Double},
        {paper, 14, 60, 55, 0.01, 0.238, Neighbours::Double},
        {paper, 14, 1, 10, 0.01, 0.097, Neighbours::SecondNeighbours},
        {paper, 14, 1, 55, 0.01, 0.015, Neighbours::SecondNeighbours},
        {paper, 14, 10, 55, 0.01, 0.027, Neighbours::SecondNeighbours},
        {paper, 14, 60, 40, 0.01, 0.131, Neighbours::SecondNeighbours},
        {paper, 14, 60, 55, 0.01, 0.094, Neighbours::SecondNeighbours},
        {paper, 14, 60, 200, 0.01, 0.023, Neighbours::SecondNeighbours},
    };
    constexpr const char* more[]{"", ", each twice", " and to second neighbours"};
    for (const Hang& hang : hangs) {
        char title[120];
        std::snprintf(title, sizeof title,
                      "rope of %d rods%s, load %g nodes, %d sweeps, dt %g s, longer by, ",
                      hang.count, more[std::size_t(hang.ties)], hang.load, hang.sweeps,
                      hang.timeStep);
        const double digits = hang.percent < 0.01 ? 0.5e-4 : 0.5e-3; // what was rounded away
        cases.push_back({"T-K2", title + nameOf(hang.solver), hang.percent,
                         within(std::max(0.02 * hang.percent, digits)), "%",
                         "independent small program, double precision",
                         [=] { return elongation(hang); }});
    }
    // That program's Gauss-Seidel goes down the rope in order; ours takes colours, there and back,
    // so only the ranking is compared.
    for (const auto& [load, averaged] : {std::pair(1.0, 0.043), {10.0, 0.073}, {60.0, 0.238}})
        cases.push_back({"T-K2",
                         "rope of 14 rods, load " + std::to_string(int(load))
                             + " nodes, 55 sweeps, longer by, gauss_seidel",
                         averaged, atMost, "%", "stiffer than averaging", [load = load] {
                             return elongation({Solver::GaussSeidel, 14, load, 55, 0.01, 0.0});
                         }});
}

// 5 kg on four rods of 0.5 m with 100 g between.
struct Held
{
    double top;  // N, tension of the first rod
    double low;  // N, of the last
    double down; // m, longer in all
};

Held held(SolvedBy by, Resists resists, double compliance)
{
    System system = heavySystem(1.0 / 1000.0);
    system.viscosity = 5.0;
    solve(system, by, 100);
    addPin(system, Vec3::Zero());
    for (int i = 1; i <= 4; ++i) {
        addParticle(system, {0.0, -0.5 * i, 0.0}, i == 4 ? 5.0 : 0.1);
        addRod(system, i - 1, i, 0.5, compliance).resists = resists;
    }
    finish(system);
    const State state = runFor(system, 5.0);
    const std::vector<double> tension = tensions(system, state);
    return {tension[0], tension[3], -state.position[4].y() - 2.0};
}

// The paper's averaging is left out: it pushes the two ends of a rod by different impulses, so
// there is no one tension to compare.
void addTensions(std::vector<Case>& cases)
{
    for (const SolvedBy solver : {SolvedBy(Solver::AveragedJacobi), SolvedBy(Solver::GaussSeidel),
                                  SolvedBy(Solver::Direct), SolvedBy()})
        for (const double compliance : {0.0, 1e-4})
            for (const Resists resists : {Resists::Both, Resists::Tension}) {
                // the default wants no accuracy of the pull of rods that never stretch
                if (!solver && compliance == 0.0)
                    continue;
                const std::string by =
                    std::string(", 5 kg on four ") + (compliance > 0.0 ? "elastic " : "")
                    + (resists == Resists::Both ? "rods, " : "lines, ") + nameOf(solver);
                const auto hang = shared([=] { return held(solver, resists, compliance); });
                cases.push_back({"T-K7", "tension at the top" + by, 5.3 * standardGravity,
                                 relative(0.01), "N", "weight below", [=] { return hang().top; }});
                cases.push_back({"T-K7", "tension at the load" + by, 5.0 * standardGravity,
                                 relative(0.01), "N", "weight below", [=] { return hang().low; }});
                if (compliance > 0.0)
                    cases.push_back({"T-K7", "longer by" + by,
                                     (5.0 + 5.1 + 5.2 + 5.3) * standardGravity * compliance,
                                     relative(0.01), "m", "weight x compliance",
                                     [=] { return hang().down; }});
            }
    for (const Integrator integrator : allIntegrators)
        cases.push_back({"T-K7", "tension, 5 kg on one rod, " + nameOf(integrator),
                         5.0 * standardGravity, relative(0.01), "N", "m g", [=] {
                             System system = heavySystem(1.0 / 1000.0, integrator);
                             addPin(system, Vec3::Zero());
                             addParticle(system, {0.0, -1.0, 0.0}, 5.0);
                             addRod(system, 0, 1, 1.0);
                             finish(system);
                             return run(system, 1000).rodTension[0];
                         }});
}

} // namespace

std::vector<Case> hangCases()
{
    std::vector<Case> cases;
    addElongations(cases);
    addTensions(cases);
    return cases;
}

} // namespace ripstop
