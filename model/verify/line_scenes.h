// What cases of cables and of cable nets begin with: a scene by default, or with the direct solver.
#pragma once

#include "builders/network.h"
#include "verify/by_default.h"

#include <array>

namespace ripstop {

inline constexpr std::array<SolvedBy, 2> solvers{SolvedBy(), SolvedBy(Solver::Direct)};

// A new scene wants pulls that are true to 1 %, and where loads are heavy enough for sweeps, it
// gets no more than that.
inline Tolerance ofPull(SolvedBy by, double share) { return relative(by ? share : 0.01); }

// Without air; brought to rest at a rate near `slowest`, the lowest angular frequency, 1/s.
inline Scene emptyScene(SolvedBy by, double slowest)
{
    Scene scene;
    scene.settings.airDensity = 0.0;
    scene.settings.viscosity = 2.0 * slowest;
    if (by)
        scene.settings.solver = *by;
    return scene;
}

inline Id addCord(Scene& scene, double axial) // N, EA
{
    Material cord;
    cord.axialStiffness = axial;
    return addItem(scene, cord);
}

} // namespace ripstop
