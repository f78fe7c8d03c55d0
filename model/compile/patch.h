// What an edit of values changes in a System, so that a running one takes it over in place.
//
// A patch holds values, not differences from a moment: it names each thing that the edit touched
// and says what the full compile would say of it. It fits the system that it was made for and any
// later one of the same structure, and patches are applied in the order in which they were made.
#pragma once

#include "compile/resolve.h"

#include <optional>
#include <utility>
#include <vector>

namespace ripstop {

struct Patch
{
    template <typename T>
    using At = std::vector<std::pair<int, T>>; // places and what stands there now

    std::uint64_t generation = 0;
    std::uint64_t run = 0;

    std::optional<Settings> settings;
    std::vector<std::pair<Key, Material>> materials; // for everything made of them
    At<Particle> particles;
    At<Spring> springs; // by place in System::links, as is all that concerns links
    At<Rod> rods;
    At<LinkStuff> linkStuff;
    At<Key> panels;                             // their materials
    std::vector<std::pair<Key, ClothLaw>> laws; // of materials, after those above
    At<PanelCut> cuts;                          // by place in System::membranes, as are
    At<double> factors;                         // ElementFactors::stiffness

    std::optional<Winds> winds;
    std::optional<std::vector<Obstacle>> obstacles;
    std::optional<std::vector<FabricLayer>> fabricLayers;
    std::optional<std::vector<Input>> inputs;
    std::optional<std::vector<ProbeSpec>> probes;
};

// Changes `system`, which nobody else may be reading, into what a compile of the edited scene
// gives. The time is that of the things named, and of one pass over links for materials.
// Returns whether what a Layout says may have changed: rest lengths, pins, probes.
bool apply(const Patch& patch, System& system);

} // namespace ripstop
