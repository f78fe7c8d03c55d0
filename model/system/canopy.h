// Fabric that holds air, and the air that it holds.
//
// Canopy is part of a System: which panels enclose the air, and the numbers of its laws; compile()
// finds it. CanopyAir is part of a State: how much air there is and how it moves. Equations,
// sources and the meaning of the numbers stand in forces/canopy_air.h, which alone moves the air
// on.
#pragma once

#include "base/vec3.h"
#include "system/key.h"

#include <array>
#include <vector>

namespace ripstop {

struct Canopy
{
    struct Facet
    {
        int panel;
        std::array<int, 3> corner; // places in `particles`; normal (b - a) x (c - a) points out
        double share;              // 1, of the area of the cloth

        friend bool operator==(const Facet&, const Facet&) = default;
    };
    Key part = 0;
    int piece = 0;                    // of the fabric of that part
    double pressureCoefficient = 0.0; // 1, inside to outside over the dynamic pressure
    double fillEfficiency = 0.0;      // 1
    double addedMass = 0.0;           // 1, over the air in a hemisphere on the mouth
    double area = 0.0;                // m^2, of the cloth
    std::vector<int> particles;       // particle indices
    std::vector<Facet> facets;
    std::vector<int> mouth;              // places in `particles`, once around
    std::vector<std::vector<int>> vents; // places in `particles`, wound as the mouth is

    friend bool operator==(const Canopy&, const Canopy&) = default;
};

// The air of a canopy at an instant.
struct CanopyAir
{
    bool started = false;
    double volume = 0.0;      // m^3, of the air; that of the canopy is a little less
    double pressure = 0.0;    // Pa, inside over outside
    double fullness = 0.0;    // 1, that pressure over the most that there can be
    double addedMass = 0.0;   // kg
    double momentum = 0.0;    // kg m/s of the added mass relative to the wind, towards the crown
    Vec3 push = Vec3::Zero(); // N, of the added mass on all panels together

    friend bool operator==(const CanopyAir&, const CanopyAir&) = default;
};

} // namespace ripstop
