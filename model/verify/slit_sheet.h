// A sheet with a slit that is drawn slowly until it tears by energy, as fracture mechanics has it.
//
// A wide sheet with a slit of 2 a tears at sqrt(G E t / (pi a)) (Griffith 1921), where G = 2 F is
// what the tear takes up (tearEnergyOf()), and one of the width W at sqrt(cos(pi a / W)) of that
// (Feddersen 1966). This one is three times as wide as its slit, held by its edges.
#pragma once

#include "simulation/simulation.h"
#include "verify/flat_cloth.h"

namespace ripstop {

struct SlitSheet
{
    static constexpr double side = 0.6;         // m, of the sheet
    static constexpr double halfSlit = 0.1;     // m, a
    static constexpr double stiffness = 4e4;    // N/m, E t
    static constexpr double poisson = 0.2;      // 1
    static constexpr double tearStrength = 1.0; // N, F

    int cells = 42; // along a side, a multiple of 6
    TearMesh tearMesh = TearMesh::Vanish;
    bool isBlunt = false; // a row of cells is cut out; else two lips that touch
    bool pushes = true;

    static double expected(); // N/m, at which it tears
};

struct SlitTorn
{
    double began = 0.0; // N/m, the last load without a tear
    double most = 0.0;  // N/m, at any time
    double left = 0.0;  // N/m, at the end
    State::Tear first{};
};

// Draws it until it bears less than two fifths of what it began at, or for 6 s.
SlitTorn drawnApart(const SlitSheet& sheet);

} // namespace ripstop
