// The networks that every speed figure is about.
//
// Square cloths of side 1 m and 0.2 kg/m^2, horizontal at the start and pinned at two corners, tied
// by structural rods, both diagonals and rods to the second neighbour: 502, 5 826, 59 002 and
// 595 978 rods for 10, 32, 100 and 316 particles a side. The paper's glider (49 particles, 198
// rods, 64 panels) and kite (152, 458, 221), from their builders. A rope with a pilot on its end.
// Step of 10 ms, viscosity 0.2/s.
#pragma once

#include "base/result.h"
#include "system/system.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ripstop {

struct BenchNetwork
{
    std::string name;               // cloth_32, glider, glider_air, ...
    std::size_t judged = 0;         // how many of its first links count for the largest strain
    bool inAir = false;             // panels, wind and ground are there
    std::shared_ptr<System> system; // finished; solver, substeps and sweeps may still be chosen
};

struct NetworkSize
{
    std::size_t particles;
    std::size_t rods;
};

NetworkSize clothSize(int side); // without building it

// Systems are finished for a solver: some choose there which rods to take together. A system for
// Gauss-Seidel serves the other sweeps too.
BenchNetwork clothNetwork(int side, Solver solver = Solver::GaussSeidel); // particles a side

// 100 rods of 0.1 m between nodes of 1 g, pinned above, 65 kg below; taut, 60 degrees from straight
// down at the start, so that theory knows its path (quality.h).
BenchNetwork ropeNetwork(Solver solver = Solver::GaussSeidel);

enum class Air { Without, With };
Result<BenchNetwork> craftNetwork(std::string_view name, Air air,
                                  Solver solver = Solver::GaussSeidel); // glider or kite

// The network with that name: glider, glider_air, kite, kite_air, rope_pilot, cloth_N.
BenchNetwork networkCalled(const std::string& name, Solver solver = Solver::GaussSeidel);

// The largest strain, 1, of rods that resist it, over the judged links.
double largestStrain(const BenchNetwork& network, const State& state);

} // namespace ripstop
