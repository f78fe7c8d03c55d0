// Air that fills fabric through a mouth: a parachute that opens and stays open by itself.
//
// The panels of a canopy and flat lids over its mouth and its vents enclose the volume V, by the
// divergence theorem. It holds air of the volume Va. The wind through the mouth, of speed U along
// the axis (from the middle of the mouth to that of the cloth), brings in more,
//
//     dVa/dt = e (A U sqrt(1 - p / P) - Q),   e = min(1, f sqrt(S / A)),
//
// with A the area of the mouth across the axis, S that of the cloth, f the fill efficiency and Q
// what leaks. Of an open tube all of the wind that meets it comes in (e = 1), of a full canopy most
// flows around it. With e falling as the width of the mouth grows, the drag area grows with the
// square of time, as that of solid cloth does (Knacke 1991, figure 5-51), and a canopy fills
// within the same number of diameters at any speed.
//
// The air is at the pressure p = K (Va - V) over that outside, from 0 to P. The most that there can
// be is that of air at rest inside, Cp q with q = rho U^2 / 2, less what the leak takes:
//
//     P = Cp q / (1 + c sqrt(Cp))^2,   c = mean porosity of the cloth + 0.6 vents / S,
//
// the law that porous panels have (panel_load.h). Q = sqrt(2 p / rho) (c' min(S, 2 A) + 0.6 vents)
// as cloth in folds does not leak. K is stiff, P per 2 % of the volume; p is that of the end of the
// substep, with what p itself does to V until then, so that no step is too long for it; at rest
// the air fills V + p / K, however long the substep is.
//
// While it fills, the load on a panel goes over from that of its air law, air that flows past, to
// pressure, air at rest. With s = p / P:
//
//     F = (1 - s) Fn + p A n + Ft,
//
// where Fn is across the panel and Ft along it, skin friction.
//
// Added mass: ma = k rho 2/3 pi (A / pi)^(3/2), the air of a hemisphere on the mouth, moves with
// the canopy along its axis. Air and canopy exchange momentum as two bodies that rub until they
// have one velocity, within 0.03 s; in a substep never more than makes them so, which is stable for
// any ratio of masses. The impulse goes to the panels by their shares of the cloth.
//
// Sources: Taylor (R&M 862) for the shape under uniform pressure; Knacke 1991, chapter 5, for fill
// time and drag area; the rest is ours.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

// What belongs to a particle of a canopy: a third of each panel around it.
struct CanopyCorner
{
    Vec3 area = Vec3::Zero(); // m^2, along the outward normals
    double share = 0.0;       // 1, of the area of the cloth
};

// Advances the air of all canopies by a substep. It holds scratch arrays only, and belongs to one
// thread.
class CanopyFiller
{
public:
    void prepare(const System& system); // before a step; takes memory when the system is new
    void advance(const System& system, State& state, double h); // h in s

private:
    std::vector<CanopyCorner> m_corners; // [particles of a canopy]
};

// Turns the loads of panels into those with the air of their canopies, as it is in the state.
//   load  [panels]  N
void addCanopyLoads(const System& system, const State& state, ThreadPool& pool,
                    std::span<PaddedVec3> load);

} // namespace ripstop
