// Experiments that pick a solver, with a step and sweeps that suit it, run once more by default: as
// a new scene would, by what Settings begin with. Loads, air and viscosity stay those of the
// experiment. A stiffness that is typed is then seen to be the one that is flown, without anybody
// having chosen how.
#pragma once

#include "compile/resolve.h"
#include "forces/spring_force.h"
#include "laws/step_limit.h"
#include "verify/sections.h"
#include "verify/small_systems.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ripstop {

// What solves an experiment; none is by default.
using SolvedBy = std::optional<Solver>;

inline constexpr const char* withSubsteps = ", by default with the substeps that it asks for";

inline std::string nameOf(SolvedBy by) { return by ? nameOf(*by) : "by default"; }

// Of an experiment that has no solver to pick: steps as fine as it wants them, or by default.
enum class Stepping { Fine, ByDefault };

inline void solveByDefault(System& system)
{
    Settings settings;
    settings.gravity = system.gravity;
    settings.airDensity = system.airDensity;
    settings.viscosity = system.viscosity;
    takeSettings(settings, system);
}

// With the step that the system has and so many sweeps, or by default.
inline void solve(System& system, SolvedBy by, int sweeps)
{
    if (!by)
        return solveByDefault(system);
    system.solver = *by;
    system.sweeps = sweeps;
}

// Springs leave the substep to the author, whom the check of a scene tells how many they need: one
// click there takes them over. The system must be finished.
inline void takeSubstepsForSprings(System& system)
{
    double limit = std::numeric_limits<double>::infinity(); // s
    for (std::size_t i = 0; i < system.mass.size(); ++i) {
        const SpringSum springs = springsAt(system, system.start, i);
        if (system.inverseMass[i] > 0.0)
            limit = std::min(limit, springStepLimit(system.mass[i], springs.stiffness,
                                                    springs.damping, system.integrator));
    }
    system.substeps = std::max(system.substeps, int(std::ceil(system.timeStep / limit)));
}

inline State runFor(const System& system, double seconds)
{
    return run(system, int(std::lround(seconds / system.timeStep)));
}

} // namespace ripstop
