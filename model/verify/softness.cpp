// How soft rods become that get a single sweep per substep.
//
// A rope of N = 20 elastic rods hangs still under its own weight, with substeps of h w, where
// w = sqrt(k/m). The rods of a substep must carry the weight below them, whatever the order; each
// is left longer by what rods that are swept after it undo. In one and the same order with two
// colours that makes the rope as stiff as
//     r = 1 / (1 + (h w)^2 (1 - 1/N)),  to within 1/N^2 of the bracket.
// Small steps shuffle the colours in each substep. A rod that is swept first then takes more than
// its share, the rod after it undoes that, and the mean is softer. The mean state is still the
// fixed point of a linear map, the mean of the maps of all orders, which is solved here with
// matrices.
#include "assembly/finish.h"
#include "constraints/rod_solver.h"
#include "verify/by_default.h"

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

constexpr int count = 20;
constexpr double springStiffness = 1000.0; // N/m
constexpr double particleMass = 0.001;     // kg

System elasticRope(double hw, Solver solver, int sweeps)
{
    System system = heavySystem(hw * std::sqrt(particleMass / springStiffness));
    system.solver = solver;
    system.sweeps = sweeps;
    system.viscosity = 0.02 / system.timeStep;
    addPin(system, Vec3::Zero());
    for (int i = 1; i <= count; ++i) {
        addParticle(system, {0.0, -1.0 * i, 0.0}, particleMass);
        addRod(system, i - 1, i, 1.0, 1.0 / springStiffness);
    }
    finish(system);
    return system;
}

double naturalLength() // m, of the extension under the own weight
{
    return 0.5 * count * (count + 1) * particleMass * standardGravity / springStiffness;
}

// Substeps in which the slowest mode, w pi / 2N, has died away.
int settled(double hw) { return int(8000.0 / std::min(1.0, hw * hw * 8.0)); }

double ratioInSteps(double hw, Solver solver, int sweeps)
{
    const System system = elasticRope(hw, solver, sweeps);
    Stepper stepper;
    State state = run(system, settled(hw));
    double mean = 0.0;
    const int samples = 40000;
    for (int i = 0; i < samples; ++i) {
        stepper.step(system, state);
        mean += (-state.position.back().y() - count) / samples;
    }
    return naturalLength() / mean;
}

double ratioByDefault()
{
    System system = elasticRope(1.0, Solver::GaussSeidel, 1);
    system.viscosity = 5.0;
    solveByDefault(system);
    finish(system);
    return naturalLength() / (-runFor(system, 10.0).position.back().y() - count);
}

// The softness with the solver alone, which is told one and the same order in each substep.
double ratioInOneOrder(double hw)
{
    const System system = elasticRope(hw, Solver::GaussSeidel, 1);
    const double h = system.timeStep;
    State state = system.start;
    const std::vector<double> restLength(system.rods.size(), 1.0);
    RodSolver rods;
    ThreadPool pool(1);
    const RodTask task{system, Solver::GaussSeidel, 1, {}, state.rodTorn, restLength, h,
                       0,      state.position};
    rods.start(task, state.rodTension);
    for (int step = settled(hw); step > 0; --step) {
        const std::vector<PaddedVec3> before = state.position;
        for (std::size_t i = 1; i < before.size(); ++i)
            state.position[i] += h * state.velocity[i] + h * h * system.gravity;
        rods.project(task, pool);
        for (std::size_t i = 1; i < before.size(); ++i)
            state.velocity[i] = 0.98 * (state.position[i] - before[i]) / h;
    }
    return naturalLength() / (-state.position.back().y() - count);
}

// What sweeping one colour does to the displacements of the nodes below the pin.
Eigen::MatrixXd sweepOf(const System& system, int colour, double hw)
{
    Eigen::MatrixXd sweep = Eigen::MatrixXd::Identity(count, count);
    for (int r = system.colorStart[std::size_t(colour)];
         r < system.colorStart[std::size_t(colour) + 1]; ++r) {
        const int below =
            std::max(system.rods[std::size_t(r)].a, system.rods[std::size_t(r)].b) - 1;
        const double share = 1.0 / ((below > 0 ? 2.0 : 1.0) + 1.0 / (hw * hw));
        Eigen::RowVectorXd length = Eigen::RowVectorXd::Zero(count);
        length(below) = 1.0;
        if (below > 0)
            length(below - 1) = -1.0;
        Eigen::MatrixXd one = Eigen::MatrixXd::Identity(count, count);
        one.row(below) -= share * length;
        if (below > 0)
            one.row(below - 1) += share * length;
        sweep = one * sweep;
    }
    return sweep;
}

// The mean over all orders of the colours.
double shuffledRatio(double hw)
{
    const System system = elasticRope(hw, Solver::SmallSteps, 1);
    std::vector<int> order(system.colorStart.size() - 1);
    std::iota(order.begin(), order.end(), 0);
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(count, count);
    int orders = 0;
    do {
        Eigen::MatrixXd map = Eigen::MatrixXd::Identity(count, count);
        for (const int colour : order)
            map = sweepOf(system, colour, hw) * map;
        mean += map;
        ++orders;
    } while (std::next_permutation(order.begin(), order.end()));
    mean /= orders;
    const double h = system.timeStep;
    const Eigen::VectorXd fall = Eigen::VectorXd::Constant(count, h * h * standardGravity);
    const Eigen::VectorXd rest =
        (Eigen::MatrixXd::Identity(count, count) - mean).partialPivLu().solve(mean * fall);
    return naturalLength() / rest(count - 1);
}

} // namespace

std::vector<Case> softnessCases()
{
    std::vector<Case> cases;
    for (const double hw : {0.1, 0.2294, 0.5, 1.0, 2.0}) {
        char where[60];
        std::snprintf(where, sizeof where, ", N %d, h w %g", count, hw);
        cases.push_back({"T-K7",
                         std::string("stiffness left by one sweep in a fixed order") + where,
                         1.0 / (1.0 + hw * hw * (1.0 - 1.0 / count)), relative(0.01), "",
                         "1 / (1 + (h w)^2 (1 - 1/N))", [=] { return ratioInOneOrder(hw); }});
        cases.push_back({"T-K7", std::string("stiffness left by small steps, shuffled") + where,
                         shuffledRatio(hw), relative(0.01), "",
                         "fixed point of the mean over all orders",
                         [=] { return ratioInSteps(hw, Solver::SmallSteps, 1); }});
    }
    cases.push_back({"T-K7", "stiffness left by 10 sweeps, N 20, h w 0.5", 1.0, within(1e-4), "",
                     "converged", [] { return ratioInSteps(0.5, Solver::GaussSeidel, 10); }});
    cases.push_back({"T-K7", "stiffness left by default, N 20", 1.0, within(0.01), "",
                     "accuracy that a new scene wants", ratioByDefault});
    return cases;
}

} // namespace ripstop
