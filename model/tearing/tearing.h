// Tearing: links that break when they are above their limit, and the panels beside them that vanish
// with them or part; panels that carry the pull of a fabric, which tear by it themselves
// (panel_tearing.h); and spars that snap where they are bent too far (spar_snapping.h).
//
// The stepper calls tearOverloaded() within a substep; cuts and the parting of the mesh call the
// others between two steps. Nothing here fails: what breaks is noted in the State.
#pragma once

#include "system/system.h"
#include "tearing/overload.h"
#include "tearing/tear_tips.h"

#include <span>

namespace ripstop {

// What the substep knows of the loads on links.
struct TearLoads
{
    std::span<const double> rodLength;       // [rods] m, before projection
    std::span<const PaddedVec3> springForce; // [springs] N, on end `a`
    std::span<const double> restLength;      // [rods] m
    std::size_t tearsBefore = 0;             // breaks before this time step
    bool mayPart = true;                     // the mesh, which it does between two time steps
};

// What a run keeps from one call to the next, so that little is found twice.
struct TearScratch
{
    std::vector<Overload> overloads;
    TearTips tips;
    double late = 0.0; // 1, the most by which a line or spar bore more than it holds when it broke
};

// Breaks links and panels above their limit (above, not at) and notes the events. A rod is judged
// by its length before projection, since none is ever long afterwards, or by its multiplier.
//
// Of links that are one line, as nothing else meets where they do, the most overloaded breaks
// alone: the others lose their load by it, and are judged again when they have had the time to
// (line_parting.h).
//
// Without System::tearsPerStep all others break, in order: the links, then the panels, then spars
// by their moments, the worst first, as the pieces beside a spar that has snapped lose theirs. With
// it, the most overloaded break first and of equals the first in that order; who is left over is
// judged again in the next substep, when the breaks have moved the load.
//
// Where the mesh is to split instead of losing panels (TearMesh::Split), what it parts by is judged
// once in a time step, after its last substep; lines and spars are judged in each, as they break
// alone. The worst break first, and of those that share a particle only one; a link that is the
// edge of a panel is noted in State::tearHolds, a panel in State::panelHold, for openTears() to
// part the mesh there (tear_opening.h). What is held is let be
// until it has been below its limit, or is a quarter farther above it than what tore there was. The
// latter fades to 1/e in the time that a load needs to go: that in which a pull crosses the
// element, sqrt(m / k), and the damping time. What still pulls after that tears again.
//
// Fabric with a tear energy is judged by it at the tips of tears and notches, of tips with a panel
// in common one at a time, and around them by nothing else; such a panel does not wait.
//
// A break releases what the link held: k s^2 / 2 of a spring stretched by s, T^2 alpha / 2 of a rod
// of compliance alpha under the tension T, nothing of a stiff rod; and what the panels that go held
// of their own.
void tearOverloaded(const System& system, State& state, const TearLoads& loads,
                    TearScratch& scratch);

// The most by which a line that breaks by its force, or a spar, bears more than it holds, 1; 0 where
// none does.
double mostOverloadOfLines(const System& system, const State& state);

// Breaks a link between two steps, whatever its limit: by a cut, or as it has lost its panels.
void breakLink(const System& system, State& state, int link);

// The same for one that is only noted: an edge along which a cut parts the mesh stays whole, on
// either side.
void noteBreak(const System& system, State& state, int link);

} // namespace ripstop
