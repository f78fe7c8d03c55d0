// Wings of a system: fabric with the vortex law (base/vortex_wing.h).
#pragma once

#include "base/vortex_wing.h"
#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

// Finds the wings anew, from where the particles start and the wind there, gusts apart.
void listWings(System& system);

// Holds scratch memory only.
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
