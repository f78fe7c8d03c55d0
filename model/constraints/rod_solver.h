// Rod solvers: they move particles until rods have their lengths. Every solver works on one
// substep, after the forces have moved the particles and before contact.
//
// The Stepper has one RodSolver and calls start(), project() for each substep, then takeTensions(),
// from the thread that steps. The solver keeps scratch and preparations of its own and nothing of
// the run: what goes on from step to step is the tension of rods, which is part of the State.
#pragma once

#include "constraints/coloured_sweeps.h"
#include "constraints/direct_solver.h"
#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// What a solver reads and writes in one substep.
struct RodTask
{
    const System& system;
    Solver solver;                        // any but Auto
    int sweeps;                           // or iterations of the direct solver
    std::span<const std::uint8_t> direct; // [rods] 1 in a direct block beside sweeps, or empty
    std::span<const std::uint8_t> torn;   // [rods] 1 where it has torn
    std::span<const double> restLength;   // [rods] m, weight shifts and damping included
    double h;                             // s
    std::uint64_t seed;                   // of the order of the colours; the number of the substep
    std::span<PaddedVec3> position;       // [particles] m, corrected in place
    std::span<const PaddedVec3> before = {};       // [particles] m, at the start of the substep
    std::span<const PaddedVec3> acceleration = {}; // [particles] m/s^2, of forces
    std::span<const PaddedVec3> nearby = {};       // [particles] m, near where it leads, or empty
    std::span<const Mat3> damping = {}; // [particles] N s/m, or empty: forces beside the rods fall
                                        // by it as rods move things; the direct solver's alone
    double tolerance = 3e-4; // 1, of lengths, where iterations of the direct solver may end
    bool note = true;        // this substep counts for takeTensions()
    bool shifted = true;     // rest lengths of shifted rods may differ from the substep before
    std::span<const std::uint8_t> gone = {}; // [panels] 1 where it is
    std::span<const PaddedVec3> drift = {};  // [particles] m/s, that BDF2 looks back by, or empty
    double substep = 0.0;                    // s, of which h is what BDF2 reaches back
    const ContactSearch* contacts = nullptr; // obstacles for the direct solver to solve with rods
    std::span<const int> damped = {}; // rods whose rest lengths differ in any case (rod_damping.h)
};

class RodSolver
{
public:
    // Before the substeps of a step: the direct solver goes on from the tensions of the one before.
    //   tension  [rods]  N
    void start(const RodTask& task, std::span<const double> tension);

    // Moves the particles of one substep, with the solver that the task asks for.
    void project(const RodTask& task, ThreadPool& pool);

    // Tension of each rod, N, multiplier / h^2, positive when the rod pulls; `h` is the substep.
    // It is the mean over the noted substeps since the last call, because single sweeps in changing
    // order share a load out differently in each substep and their mean is what the rods carry. Of
    // rods that are solved directly it is that of the last substep.
    void takeTensions(const RodTask& task, ThreadPool& pool, std::span<double> tension);

    // Those alone, which are true in each substep.
    void takeDirectTensions(std::span<double> tension) const;

    // What the global solve of the last substep has left unsolved, as an error of its pulls, 1.
    double residual() const { return m_direct.isEmpty() ? 0.0 : m_direct.residual(); }

    // J, twice the energy that errors of pulls are compared with at least (direct_solver.h).
    double leastEnergy() const { return m_direct.isEmpty() ? 0.0 : m_direct.leastEnergy(); }

    // Of the last substep, where the task lets the global solve look for them.
    std::span<const HeldContact> contacts() const { return m_direct.contacts(); }

    // Whether a line that is solved directly met its load in the last substep (direct_solver.h).
    bool hasImpact() const { return m_direct.hasImpact(); }
    bool hasLines() const { return m_direct.hasOneWay(); } // that are solved so

private:
    void average(const RodTask& task, ThreadPool& pool);
    void averagedSweep(const RodTask& task, ThreadPool& pool);
    void countRods(const RodTask& task);
    void prepareDirect(const RodTask& task);
    void projectDirect(const RodTask& task, int iterations, ThreadPool& pool);

    ColouredSweeps m_coloured;
    DirectSolver m_direct;
    std::size_t m_mayHave = 0;         // rods, of which m_direct is prepared for those that are
    std::vector<std::uint8_t> m_marks; // [rods] marked, or for all of them where it is empty
    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
    int m_substeps = 0;               // since the last call of takeTensions()
    std::vector<double> m_multiplier; // [rods] kg m, of this substep
    std::vector<double> m_tension;    // [rods] N, of the substep before; of direct rods only
    std::vector<double> m_sum;        // [rods] kg m, of all substeps; of averaged solvers only
    std::vector<Vec3> m_pull;         // [rods] kg m, or m for the paper's averaging
    std::vector<double> m_valence;    // [particles] rods that are not torn
};

} // namespace ripstop
