// How the solver moves particles on and how it holds rods: laws that a design chooses for all of
// itself. The scene says them, the stepper obeys them, and neither sees the other.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class Integrator {
    ExplicitEuler,
    SemiImplicitEuler,
    ImplicitEuler,  // of springs, rods and air; other forces are those of the start
    Verlet,         // Verlet 1967
    VelocityVerlet, // Swope, Andersen, Berens and Wilson 1982
    Bdf2,           // backward differences of second order (Curtiss and Hirschfelder 1952)
    RungeKutta4,    // Kutta 1901
    Auto            // what step/solver_plan.h chooses
};
template <>
inline constexpr std::array<std::string_view, 8> choiceNames<Integrator>{"explicit_euler",
                                                                         "semi_implicit_euler",
                                                                         "implicit_euler",
                                                                         "verlet",
                                                                         "velocity_verlet",
                                                                         "bdf2",
                                                                         "rk4",
                                                                         "auto"};

// Whether springs and the air may be solved together with rods, instead of pulling as they did at
// the start of a substep.
constexpr bool isImplicit(Integrator integrator)
{
    return integrator == Integrator::ImplicitEuler || integrator == Integrator::Bdf2;
}

// Substeps of semi-implicit Euler that one of BDF2 is as true as; the automatic integrator makes as
// many fewer.
inline constexpr int substepsOfEuler = 4;

// Of a time step, that the automatic solver takes at most.
inline constexpr int mostSubsteps = 2000;

// Whether it goes on from State::drift instead of from the velocity.
constexpr bool isVerlet(Integrator integrator)
{
    return integrator == Integrator::Verlet || integrator == Integrator::VelocityVerlet;
}

// Whether it looks back one substep, and so begins anew after one of another length.
constexpr bool looksBack(Integrator integrator)
{
    return isVerlet(integrator) || integrator == Integrator::Bdf2;
}

enum class Solver {
    AveragedJacobi, // mass-split: conserves momentum (Tonge 2012)
    PaperJacobi, // each end averages its own corrections (Beaudry, Egli, Patenaude 2005, figure 8)
    GaussSeidel, // in colours, with compliance (Macklin, Mueller, Chentanez 2016)
    SmallSteps,  // Gauss-Seidel with one sweep per substep, the order of colours shuffled in each
                 // (Macklin, Storey, Lu, Terdiman, Chentanez, Jeschke and Mueller 2019)
    Direct,      // all rods together, by Newton's method; for lines, frames and heavy loads
    Auto         // small steps, as many as the wanted strain needs, and direct blocks
};
template <>
inline constexpr std::array<std::string_view, 6> choiceNames<Solver>{
    "averaged_jacobi", "paper_jacobi", "gauss_seidel", "small_steps", "direct", "auto"};

// Whether rods may be solved all at once, and the bending of spars with them.
constexpr bool solvesTogether(Solver solver)
{
    return solver == Solver::Direct || solver == Solver::Auto;
}

} // namespace ripstop
