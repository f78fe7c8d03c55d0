// Wings of a system: fabric with the vortex law (laws/vortex_wing.h).
//
// A wing is found when forces list what they derive (system/force_lists.h): its strips depend on
// where particles start. In a step WingLoads gathers what each panel of a wing is and meets, lets
// the vortex law find the loads of the wing as a whole, and adds them to those that the panels have
// as plates.
#pragma once

#include "laws/vortex_wing.h"
#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

// Finds the wings of a system anew, from where its particles start and the wind there without
// gusts. For the single owner of the system, and not beside a step.
void listWings(System& system);

// The loads of wings. It holds scratch memory only, and belongs to one thread.
class WingLoads
{
public:
    // Turns the loads of plates, which the panels of wings have until then, into those of wings.
    //   load  [panels]  N
    void add(const System& system, const State& state, std::span<PaddedVec3> load);

private:
    std::vector<WingPanel> m_panels; // of one wing
};

} // namespace ripstop
