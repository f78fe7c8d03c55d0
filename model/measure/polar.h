// The polar of an air law: what a flat plate of some material feels at each angle of attack, and
// published curves to hold beside it.
//
//     C_N = F.n / (q A),  C_L and C_D across and along the wind,  q = 1/2 rho V^2
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

struct MaterialAir; // system/panels.h

struct PolarRow
{
    double degrees; // angle of attack
    double normal;  // 1, C_N
    double lift;    // 1, C_L
    double drag;    // 1, C_D
};

// From 0 to 90 degrees; `step` in degrees. The load is that of panelLoad(); with the vortex law, of
// a rectangular plate of aspect ratio 2.
std::vector<PolarRow> platePolar(const MaterialAir& air, double step);

// A curve from the literature. All are normal forces: C_L = C_N cos, C_D = C_N sin.
struct PolarReference
{
    std::string_view key;           // short, for columns
    std::string_view name;          // with source
    double last;                    // degrees, up to where it holds
    double (*normal)(double alpha); // rad
};
std::span<const PolarReference> polarReferences();

PolarRow rowOf(const PolarReference& reference, double degrees);

} // namespace ripstop
