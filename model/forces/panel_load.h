// Wind load on fabric panels.
//
// A panel is one triangle of fabric with area A and unit normal n; w is its apparent wind, the
// wind at the panel less the mean velocity of its corners.
//
//     paper          F = 1/2 rho C A |n.w| (n.w) n    Beaudry, Egli and Patenaude 2005, 5.2, with
//                                                     the sign and the factor it lacks; its own
//                                                     strength is C = 4
//     linear normal  F = 1/2 rho C A |w| (n.w) n      flat plate, C_N = C sin(alpha); C = 2: Moore,
//                                                     Cory and Tedrake 2014
//
//                                     with saturation k = Ca / C90 - 1 the coefficient is
//                                     C_N = Ca sin(alpha) / (1 + k |sin(alpha)|): Ca at small
//                                     angles, C90 head on
//     lift drag      F = 1/2 rho A |w|^2 (CD(alpha) w/|w| + CL(alpha) l), l across w in the plane
//                                     of n and w; from a table. Wejchert and Haumann 1991. As l is
//                                     across the wind and CD >= 0, the air never gives power.
//
// Porous cloth leaks at v = c sqrt(2 dp / rho), which the head-on wind loses. The pressure falls
// with the square of what is left, dp = dp0 (1 - v / |n.w|)^2, so that
//     dp = dp0 / (1 + c u0 / |n.w|)^2,  u0 = sqrt(2 dp0 / rho)
// and the leak never exceeds the head-on wind.
//
// All laws add skin friction, 1/2 rho Cs A |t| t along t = w - (n.w) n. No law depends on
// which side the normal points to. The three corners carry a third of F each.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// Load on one panel, N. The viewport draws this same value as an arrow.
Vec3 panelLoad(const MaterialAir& air, const Vec3& a, const Vec3& b, const Vec3& c,
               const Vec3& apparentWind, double airDensity);

// Load of every panel, N, zero where the panel is gone.
//   load  [panels]  N
void fillPanelLoads(const System& system, const State& state, ThreadPool& pool,
                    std::span<PaddedVec3> load);

// The same in an apparent wind that is faster by `nudge`, m/s, along the normal of each panel.
void fillNudgedPanelLoads(const System& system, const State& state, double nudge,
                          std::span<PaddedVec3> load);

// fillPanelLoads() that is told whether to use the kernel for wide machines (simd_pack.h), which
// must not be asked of another machine. Both ways give the same bits, which tests compare.
void fillPanelLoads(const System& system, const State& state, ThreadPool& pool,
                    std::span<PaddedVec3> load, bool wide);

} // namespace ripstop
