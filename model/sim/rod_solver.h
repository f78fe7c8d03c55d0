// Rod solvers: they move particles until rods have their lengths.
//
// Every solver works on one substep. `multiplier` collects, per rod, what it took to hold it
// (kg m); multiplier / h^2 is the tension in newtons, positive when the rod pulls.
#pragma once

#include "sim/coloured_sweeps.h"
#include "sim/crew.h"
#include "sim/direct_solver.h"
#include "sim/system.h"

#include <span>

namespace ripstop {

// What a solver reads and writes in one substep.
struct RodTask
{
    const System& system;
    std::span<const std::uint8_t> torn; // [rods]
    std::span<const double> restLength; // [rods] m, weight shifts included
    double h;                           // s
    std::uint64_t seed;                 // of the order of the colours; the number of the substep
    std::span<Vec3> position;           // [particles] m, corrected in place
    std::span<double> multiplier;       // [rods] kg m, filled; on entry the tensions of the substep
                                        // before, N
};

class RodSolver
{
public:
    // All sweeps of one substep, with the solver that the system asks for.
    void project(const RodTask& task, Crew& crew);

private:
    void averagedSweep(const RodTask& task, Crew& crew);
    void countRods(const RodTask& task);
    void prepareDirect(const System& system);

    ColouredSweeps m_coloured;
    DirectSolver m_direct;
    Solver m_directFor = Solver::AveragedJacobi; // what m_direct is prepared for
    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
    std::vector<Vec3> m_pull;      // [rods] kg m, or m for the paper's averaging
    std::vector<double> m_valence; // [particles] rods that are not torn
};

} // namespace ripstop
