// Figures of a whole system in SI units: energies, momentum, strains, tensions, loads and the hash
// of a state. They read the values that they are given and nothing else, so any thread may call
// them; none fails.
#pragma once

#include "laws/panel_pull.h"
#include "system/system.h"

#include <span>
#include <string>

namespace ripstop {

struct Energies
{
    double kinetic = 0.0;   // J
    double potential = 0.0; // J, of weight, zero at the origin
    double elastic = 0.0;   // J, in springs, compliant rods, elastic panels and bends
    double total() const { return kinetic + potential + elastic; }
};

Energies energies(const System& system, const State& state);

//   restLength  [rods]  m, of now
Energies energies(const System& system, const State& state, std::span<const double> restLength);

double kineticEnergy(const System& system, const State& state); // J, of free particles

// J, in compliant rods and elastic panels. Without memory of its own.
//   restLength  [rods]  m, of now
double stretchEnergy(const System& system, const State& state, std::span<const double> restLength);

Vec3 centerOfMass(const System& system, std::span<const PaddedVec3> position); // m, pins included
Vec3 momentum(const System& system, const State& state); // kg m/s, free particles

double totalMass(const System& system);                      // kg, pins included
double fabricArea(const System& system, const State& state); // m^2, without what is gone

// Per link in the author's order; 0 where torn.
std::vector<double> strains(const System& system, const State& state);  // 1
std::vector<double> tensions(const System& system, const State& state); // N, compression negative

// What a rod that holds pulls with, N: as it was solved; before the first step what its stretch
// makes of its stiffness, and 0 where it never gives way and nothing is known yet.
double pullOfRod(const System& system, const State& state, std::size_t rod);

// Largest strain of the threads of panels that carry a pull, 1; of those with these indices,
// ascending, or of all.
double largestPanelStrain(const System& system, const State& state);
double largestPanelStrain(const System& system, const State& state, std::span<const int> panels);

// What each panel carries of the pull of its fabric, nothing where it is gone; empty where no panel
// carries any.
std::vector<PanelPull> panelPulls(const System& system, const State& state);

// The same three into arrays that are kept from one reading to the next, which takes nothing from
// the heap when they have had their sizes.
//   restLength  [rods] m, scratch
void fillStrains(const System& system, const State& state, std::vector<double>& restLength,
                 std::vector<double>& strain);
void fillTensions(const System& system, const State& state, std::vector<double>& tension);
void fillPanelPulls(const System& system, const State& state, std::vector<PanelPull>& pulls);

// Air load of each panel, N, 0 where gone.
std::vector<Vec3> panelLoads(const System& system, const State& state);

// Drag of each line, N, 0 where torn.
//   [LineLists::list]
std::vector<Vec3> lineDrags(const System& system, const State& state);

// FNV-1a over the fields that are marked so (system/fields.h: the step, positions, velocities,
// inputs, gusts and what is torn), equal for equal bits only.
std::uint64_t stateHash(const State& state);

} // namespace ripstop
