// Load over strength of every place of a design (laws/load_margin.h): of lines and spars by their
// pull, of threads and elastic panels by their pull per width, of spars by their bending moment
// too. Colours, probes, tables and the panel of loads all have their margins from here.
//
// What tears at a force or a tension of its own bears that. A thread does not say whether it is
// warp or weft, so that the weaker of both counts. The moment of a spar is the slope of its energy
// over the angle between two links (laws/bend.h); it belongs to both. What has torn bears nothing,
// and what pushes is not judged: buckling is no strength.
#pragma once

#include "laws/cloth_pack.h"
#include "system/system.h"

#include <array>
#include <span>
#include <vector>

namespace ripstop {

// The largest of each link and panel; not a number where its material has no strength of its kind,
// nor it a limit. Both are empty where nothing has any.
struct Margins
{
    std::vector<double> link;  // [links] 1
    std::vector<double> panel; // [panels] 1
};

Margins margins(const System& system, const State& state);

// What of a system has a strength, found once, so that a look at every step costs little. It holds
// until the system is another one or is edited.
struct JudgedPlaces
{
    struct OfLink
    {
        int link;
        LoadKind kind;
        double width;    // m, of the strip that a thread stands for; 1 of a line
        double strength; // N or N/m
    };
    struct FourPanels // whose law is worked out at once, as it takes no longer than that of one
    {
        std::array<int, 4> membrane{-1, -1, -1, -1}; // -1 for none
        ClothLawPack law;
        std::array<double, 4> warp{}; // N/m, strength; 0 for none
        std::array<double, 4> weft{};

        FourPanels()
        {
            for (int lane = 0; lane < 4; ++lane)
                law.clear(lane);
        }
    };
    struct OfSpar
    {
        int bend;
        double strength; // N m
    };

    std::vector<OfLink> links;
    std::vector<FourPanels> panels;
    std::vector<OfSpar> spars;

    bool isEmpty() const { return links.empty() && panels.empty() && spars.empty(); }

    // The names of places, which margins do not need. What is of one material is one line as long
    // as no third line ends at a particle of it, and one spar where it bends.
    std::vector<Key> linkName; // [System::links]
    std::vector<Key> lineName; // the same, of the first link of the line or spar
};

JudgedPlaces judgedPlacesOf(const System& system);
JudgedPlaces unnamedPlacesOf(const System& system);

// The same as margins(); takes nothing from the heap when the arrays have had their sizes.
void fillMargins(const System& system, const State& state, const JudgedPlaces& judged,
                 Margins& result);

// Offers all places, as they are loaded at the time of the state. Takes nothing from the heap, and
// neither does tornPlace().
void offerPlaces(const System& system, const State& state, const JudgedPlaces& judged,
                 WorstPlaces& worst);

// What tore, with what it bore then, as it bears nothing afterwards.
LoadedPlace tornPlace(const System& system, const State::Tear& tear, const JudgedPlaces& judged);

} // namespace ripstop
