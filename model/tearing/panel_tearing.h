// Panels that carry the pull of a fabric and tear by it, without a link.
//
// A panel is judged by what its warp and its weft threads carry (PanelPull::warp, weft) or, with
// the rule Strain, by what these are stretched by, without what damping adds. The threads that are
// most times their limit are those that break.
#pragma once

#include "laws/panel_pull.h"
#include "system/system.h"

namespace ripstop {

// The membrane of a panel, or null for one that carries nothing.
const Membrane* membraneOf(const System& system, int panel);

struct PanelVerdict
{
    ThreadLoad worst;
    PanelPull pull; // of the panel; empty where it never tears
};
// Whether it may be above a limit; told by a bound, so that most panels cost little.
bool mayTear(const System& system, const State& state, const Membrane& membrane);
PanelVerdict judge(const System& system, const State& state, const Membrane& membrane);

// Where those threads run now, of length 1.
Vec3 directionOf(const System& system, const State& state, const Membrane& membrane, int threads);

double elasticEnergyIn(const System& system, const State& state,
                       int panel); // J; 0 for what is gone

// Notes that a panel tears; `energy` in J is what it lets go of.
void noteTear(const System& system, State& state, const Membrane& membrane,
              const PanelVerdict& verdict, double energy);

} // namespace ripstop
