// A heavy load on a light line, the case that the direct solver was made for: 10 m in 100 rods
// with 1 g between them, which sweeps alone leave far too long.
//
// Masses are in kg, lengths in m, time steps in s. test_direct.cpp and test_direct_block.cpp use
// it.
#pragma once

#include "model/systems.h"

namespace ripstop {

inline System directSystem(double timeStep, int substeps)
{
    System system = emptySystem(timeStep);
    system.solver = Solver::Direct;
    system.substeps = substeps;
    system.gravity = {0.0, -standardGravity, 0.0};
    return system;
}

// The line hangs from a pin at the origin in the direction `along`, with the load (kg) at its end.
inline System heavyLine(double load, const Vec3& along)
{
    System system = directSystem(0.01, 4);
    addPin(system, Vec3::Zero());
    for (int i = 1; i <= 100; ++i) {
        addParticle(system, (0.1 * i) * along, i == 100 ? load : 0.001);
        addRod(system, i - 1, i, 0.1);
    }
    return system;
}

} // namespace ripstop
