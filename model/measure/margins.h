// Load over strength of every place of a design (base/load_margin.h): of lines and spars by their
// pull, of threads and elastic panels by their pull per width, of spars by their bending moment
// too. Colours, probes, tables and the panel of loads all have their margins from here.
//
// A thread does not say whether it is warp or weft, so that the weaker of both counts. The moment
// of a spar is the slope of its energy over the angle between two links (base/bend.h); it belongs
// to both. What has torn bears nothing, and what pushes is not judged: buckling is no strength.
#pragma once

#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

// The largest of each link and panel; not a number where its material has no strength of its kind.
// Both are empty where no material has any.
struct Margins
{
    std::vector<double> link;  // [links] 1
    std::vector<double> panel; // [panels] 1
};

Margins margins(const System& system, const State& state);

// The first link of the line or spar that each link belongs to, or itself: what is of one material
// is one line as long as no third line ends at a particle of it, and one spar where it bends.
//   [links]  indices into System::links; empty where no material has a strength
std::vector<int> chainsOf(const System& system);

// Offers all places, as they are loaded at the time of the state. Takes nothing from the heap.
//   lines  of this system
void offerPlaces(const System& system, const State& state, std::span<const int> lines,
                 WorstPlaces& worst);

// N m, the bending moment of a spar at the particle that two links share; 0 where one has torn.
double bendingMoment(const System& system, const State& state, const Bend& spar);

} // namespace ripstop
