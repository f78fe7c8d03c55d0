// Sheets: the modulus of a lattice of springs, sheets that hang, symmetry and energy.
//
// In order: the modulus of a triangular lattice, measured by a pull and by its energy (M1); and
// square sheets that hang, fall and swing (M7 to M9): largest strain, symmetry and energy.
#include "assembly/finish.h"
#include "laws/step_limit.h"
#include "measure/diagnostics.h"
#include "verify/by_default.h"

#include <Eigen/Dense>

#include <algorithm>
#include <numbers>

namespace ripstop {
namespace {

constexpr double stiffness = 1000.0; // N/m
constexpr double cell = 0.1;         // m
const double rowHeight = cell * std::sqrt(3.0) / 2.0;

// Equilateral triangles, rows along x, every other one shifted by half a cell. [rows][columns]
System lattice(int columns, int rows, double mass)
{
    System system = emptySystem(1e-4);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            addParticle(system, {cell * (i + 0.5 * (j % 2)), rowHeight * j, 0.0}, mass);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int here = j * columns + i;
            if (i + 1 < columns)
                addSpring(system, here, here + 1, cell, stiffness);
            if (j + 1 == rows)
                continue;
            const int left = i - (j % 2 ? 0 : 1); // in the row above
            for (const int k : {left, left + 1})
                if (k >= 0 && k < columns)
                    addSpring(system, here, (j + 1) * columns + k, cell, stiffness);
        }
    return system;
}

// --- M1 by a pull --------------------------------------------------------------------------------

struct Pull
{
    double modulus; // N/m
    double poisson; // 1
};

// A strip of 14 rows, each of which carries the tension of its width, a sqrt(3) / 2. The left ends
// are held by wires of a kilometre, so that the strip is free to become narrower; weights at the
// right ends are pulled along x.
Pull pull(Stepping stepping)
{
    const int columns = 41;
    const int rows = 14;
    System system = lattice(columns, rows, 1e-3);
    const double gravity = 0.1;
    system.gravity = {gravity, 0.0, 0.0};
    system.viscosity = 10.0;
    if (stepping == Stepping::ByDefault)
        solveByDefault(system);
    for (int j = 0; j < rows; ++j) {
        const std::size_t end = std::size_t(j * columns + columns - 1);
        system.mass[end] = 0.1;
        system.inverseMass[end] = 10.0;
        const int first = j * columns;
        const Vec3 place = system.start.position[std::size_t(first)];
        const int pin = addPin(system, place - Vec3(1e3, 0.0, 0.0));
        addSpring(system, pin, first, 1e3, 10.0 * stiffness);
    }
    finish(system);
    if (stepping == Stepping::ByDefault)
        takeSubstepsForSprings(system);
    const State state = runFor(system, 5.0);
    // between columns 12 and 28, and rows 3 and 11 (both shifted)
    const auto at = [&](int i, int j) { return state.position[std::size_t(j * columns + i)]; };
    const auto was = [&](int i, int j) {
        return system.start.position[std::size_t(j * columns + i)];
    };
    double along = 0.0;
    double across = 0.0;
    for (int k = 0; k <= 8; ++k) {
        along += ((at(28, 3 + k) - at(12, 3 + k)).x() / (was(28, 3 + k) - was(12, 3 + k)).x() - 1.0)
                 / 9.0;
        across +=
            ((at(16 + k, 11) - at(16 + k, 3)).y() / (was(16 + k, 11) - was(16 + k, 3)).y() - 1.0)
            / 9.0;
    }
    const double force = gravity * (0.1 + 1e-3 * 19.5); // N, mean of a row there
    return {force / rowHeight / along, -across / along};
}

// --- M1 by energy --------------------------------------------------------------------------------

// Energy of a lattice that is strained by (xx, yy, xy), over the area of its springs, J/m^2. Each
// direction is weighed alike, as in an endless lattice: each spring has a third of a node's area.
double energyDensity(double xx, double yy, double xy)
{
    System system = lattice(30, 31, 1.0);
    finish(system);
    State state = system.start;
    Eigen::Matrix3d strain = Eigen::Matrix3d::Identity();
    strain(0, 0) += xx;
    strain(1, 1) += yy;
    strain(0, 1) = strain(1, 0) = xy;
    for (auto& x : state.position)
        x = Vec3(strain * x);
    double energy[3] = {0.0, 0.0, 0.0};
    int springs[3] = {0, 0, 0};
    const std::vector<double> force = tensions(system, state);
    for (std::size_t s = 0; s < system.springs.size(); ++s) {
        const Vec3 along = system.start.position[std::size_t(system.springs[s].b)]
                           - system.start.position[std::size_t(system.springs[s].a)];
        const int sort = std::abs(along.y()) < 0.1 * cell ? 0 : along.x() * along.y() > 0.0 ? 1 : 2;
        const double tension = force[std::size_t(system.springLink[s])];
        energy[sort] += 0.5 * tension * tension / stiffness;
        ++springs[sort];
    }
    double sum = 0.0;
    for (const int sort : {0, 1, 2})
        sum += energy[sort] / springs[sort] / (cell * rowHeight);
    return sum;
}

void addLattices(std::vector<Case>& cases)
{
    const std::string sheet = "lattice of springs, 1000 N/m, ";
    for (const Stepping stepping : {Stepping::Fine, Stepping::ByDefault}) {
        const auto strip = shared([=] { return pull(stepping); });
        const std::string by = stepping == Stepping::Fine ? "" : withSubsteps;
        cases.push_back({"T-M1", sheet + "Young's modulus, strip of 14 rows" + by,
                         2.0 * stiffness / std::sqrt(3.0), relative(0.02), "N/m", "2 k / sqrt(3)",
                         [=] { return strip().modulus; }});
        cases.push_back({"T-M1", sheet + "Poisson's ratio, strip of 14 rows" + by, 1.0 / 3.0,
                         relative(0.02), "", "1/3", [=] { return strip().poisson; }});
    }
    const double e = 1e-6; // strain; what is left over is of its order
    cases.push_back({"T-M1", sheet + "shear modulus", std::sqrt(3.0) * stiffness / 4.0,
                     relative(1e-4), "N/m", "sqrt(3) k / 4",
                     [=] { return energyDensity(0.0, 0.0, e) / (2.0 * e * e); }});
    cases.push_back({"T-M1", sheet + "shear modulus, other direction",
                     std::sqrt(3.0) * stiffness / 4.0, relative(1e-4), "N/m", "isotropic",
                     [=] { return energyDensity(e, -e, 0.0) / (2.0 * e * e); }});
    cases.push_back({"T-M1", sheet + "area modulus", std::sqrt(3.0) * stiffness / 2.0,
                     relative(1e-4), "N/m", "sqrt(3) k / 2",
                     [=] { return energyDensity(e, e, 0.0) / (2.0 * e * e); }});
}

// --- M7 to M9 ------------------------------------------------------------------------------------

// A square sheet of n x n cells, 1 m wide, in the xz plane from the edge z = 0, with both
// diagonals.
template <typename Tie>
void addSheet(System& system, int cells, double mass, const Tie& tie)
{
    const int side = cells + 1;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            addParticle(system, {double(i) / cells - 0.5, 0.0, double(j) / cells},
                        mass / (side * side));
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int here = j * side + i;
            if (i + 1 < side)
                tie(here, here + 1, 1.0);
            if (j + 1 < side)
                tie(here, here + side, 1.0);
            if (i + 1 < side && j + 1 < side) {
                tie(here, here + side + 1, 0.3);
                tie(here + 1, here + side, 0.3);
            }
        }
}

double hungStrain(Solver solver) // 1, the largest of 0.2 kg of rods that hang by two corners
{
    System system = heavySystem(1.0 / 240.0);
    system.substeps = 4;
    system.solver = solver;
    system.sweeps = 20;
    system.strainGoal = 0.01;
    system.viscosity = 1.0;
    addSheet(system, 20, 0.2, [&](int a, int b, double share) {
        if (share == 1.0) // diagonals would make a plate of it
            addRod(system, a, b, distance(system, a, b));
    });
    system.inverseMass[0] = system.inverseMass[20] = 0.0;
    finish(system);
    const State state = run(system, 1920);
    double most = 0.0;
    for (const double strain : strains(system, state))
        most = std::max(most, strain);
    return most;
}

// Largest distance between a sheet that fell from two corners and its mirror image. Without
// viscosity it swings and buckles, and what is 1e-15 at first grows a thousandfold in half a
// second: it is asked early, and of the sheet at rest.
double asymmetry(bool rods, double viscosity, double time)
{
    const int cells = 16;
    System system = heavySystem(1.0 / 1000.0);
    system.solver = Solver::AveragedJacobi;
    system.sweeps = 30;
    system.viscosity = viscosity;
    addSheet(system, cells, 0.2, [&](int a, int b, double share) {
        if (rods)
            addRod(system, a, b, distance(system, a, b));
        else
            addSpring(system, a, b, distance(system, a, b), 60.0 * share, 0.005);
    });
    system.inverseMass[0] = system.inverseMass[cells] = 0.0;
    finish(system);
    const State state = run(system, int(std::lround(time / system.timeStep)));
    double most = 0.0;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            Vec3 other = state.position[std::size_t(j * (cells + 1) + cells - i)];
            other.x() = -other.x();
            most =
                std::max(most, (state.position[std::size_t(j * (cells + 1) + i)] - other).norm());
        }
    return most;
}

// Largest change of the energy of a sheet in its frame that swings in its lowest mode, over 1e4
// steps at half the step limit of its springs.
double energyChange(Integrator integrator)
{
    const int cells = 20;
    System system = emptySystem(1.0, integrator);
    addSheet(system, cells, 0.2, [&](int a, int b, double share) {
        addSpring(system, a, b, 0.9 * distance(system, a, b), 60.0 * share);
    });
    const double node = 0.2 / ((cells + 1) * (cells + 1));
    system.timeStep = 0.5 * springStepLimit(node, 4.0 * 60.0 * 1.3, 0.0, integrator);
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const std::size_t here = std::size_t(j * (cells + 1) + i);
            if (i % cells == 0 || j % cells == 0)
                system.inverseMass[here] = 0.0;
            else
                system.start.velocity[here] = Vec3(0.0,
                                                   0.5 * std::sin(std::numbers::pi * i / cells)
                                                       * std::sin(std::numbers::pi * j / cells),
                                                   0.0);
        }
    finish(system);
    Stepper stepper;
    State state = system.start;
    const double before = energies(system, state).total();
    double most = 0.0;
    for (int i = 0; i < 10000; ++i) {
        stepper.step(system, state);
        most = std::max(most, std::abs(energies(system, state).total() / before - 1.0));
    }
    return most;
}

void addSheets(std::vector<Case>& cases)
{
    for (const Solver solver : {Solver::GaussSeidel, Solver::Auto})
        cases.push_back(
            {"T-M7", "sheet of rods that hangs by two corners, largest strain, " + nameOf(solver),
             0.10, atMost, "", "limit of Provot 1995", [=] { return hungStrain(solver); }});
    for (const bool rods : {false, true}) {
        const std::string of = rods ? ", rods, averaged_jacobi" : ", springs";
        cases.push_back(
            {"T-M8", "sheet that falls from two corners, gap to its mirror image at 0.8 s" + of,
             0.0, within(1e-9), "m", "symmetry", [=] { return asymmetry(rods, 0.0, 0.8); }});
        cases.push_back({"T-M8", "sheet at rest on two corners, gap to its mirror image" + of, 0.0,
                         within(1e-9), "m", "symmetry; viscosity 4 1/s, 8 s",
                         [=] { return asymmetry(rods, 4.0, 8.0); }});
    }
    for (const Integrator integrator : {Integrator::SemiImplicitEuler, Integrator::VelocityVerlet})
        cases.push_back({"T-M9",
                         "swinging sheet, change of energy in 1e4 steps at half the limit, "
                             + nameOf(integrator),
                         0.01, atMost, "", "symplectic: bounded",
                         [=] { return energyChange(integrator); }});
}

} // namespace

std::vector<Case> clothCases()
{
    std::vector<Case> cases;
    addLattices(cases);
    addSheets(cases);
    return cases;
}

} // namespace ripstop
