// Tearing: links that break when they are above their limit, and the panels beside them that vanish
// with them or part.
//
// The stepper calls tearLinks() within a substep; cuts and the parting of the mesh call the others
// between two steps. Nothing here fails: what breaks is noted in the State.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// What the substep knows of the loads on links.
struct TearLoads
{
    std::span<const double> rodLength;       // [rods] m, before projection
    std::span<const PaddedVec3> springForce; // [springs] N, on end `a`
    std::span<const double> restLength;      // [rods] m
    std::size_t tearsBefore = 0;             // breaks before this time step
};

// A link above its limit, and how far: its length, strain or force over the limit.
struct Overload
{
    int link;     // index into System::links
    double ratio; // 1
};

// Breaks links above their limit (above, not at) and notes the events. A rod is judged by its
// length before projection, since none is ever long afterwards, or by its multiplier.
//
// Without System::tearsPerStep all of them break, in the order of the links. With it, the most
// overloaded break first and of equals the first in the order of the links; who is left over is
// judged again in the next substep, when the breaks have moved the load.
//
// Where the mesh is to split instead of losing panels (TearMesh::Split), links are judged once in a
// time step, after its last substep. The worst break first, and of those that share an end only
// one; a link that is the edge of a panel is noted in State::tearHolds, for openTears() to part the
// mesh there (tear_opening.h). A link that is held is let be until it has been below its limit, or
// is a quarter farther above it than the one that tore there was.
//
// A break releases what the link held: k s^2 / 2 of a spring stretched by s, T^2 alpha / 2 of a rod
// of compliance alpha under the tension T, nothing of a stiff rod.
void tearLinks(const System& system, State& state, const TearLoads& loads,
               std::vector<Overload>& scratch);

// Breaks a link between two steps, whatever its limit: by a cut, or as it has lost its panels.
void breakLink(const System& system, State& state, int link);

// The same for one that is only noted: an edge along which a cut parts the mesh stays whole, on
// either side.
void noteBreak(const System& system, State& state, int link);

} // namespace ripstop
