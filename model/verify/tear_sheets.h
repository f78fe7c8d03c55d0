// Sheets that tear along one row, and what a mesh that splits must keep: mass, its centre,
// momentum, spin and energy. The cases of tearing and their tests judge the splitting of a mesh by
// them.
#pragma once

#include "simulation/simulation.h"
#include "verify/small_systems.h"

namespace ripstop {

// `columns` x `rows` cells of 0.1 m in a plane, two panels each, links along all their edges, the
// other diagonals and over two cells. The first row of particles is pinned, the last one is drawn
// away at 0.2 m/s. Links along the pull between the rows `weak` and `weak + 1` break at a strain of
// 0.05, all others never. No gravity, no air.
System tearSheet(int columns, int rows, int weak, LinkKind kind, double compliance = 1e-3);

// Pieces that hang together by panels or by links that are whole.
int piecesOf(const System& system, const State& state);

// The largest changes in the moments when the mesh opens, in a run of so many steps.
struct PartingChanges
{
    int partings = 0;      // moments
    double mass = 0.0;     // kg
    double centre = 0.0;   // m
    double momentum = 0.0; // kg m/s
    double spin = 0.0;     // kg m^2/s, about the origin
    double energy = 0.0;   // J, what links hold included
};
PartingChanges changesAtPartings(const System& system, int steps);

} // namespace ripstop
