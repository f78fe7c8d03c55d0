// The vortex law: the air force on a wing from a lifting line bent to its shape.
//
// Each strip of the wing (wing_strips.h) has a bound vortex at a quarter of its chord, whose ends
// trail off along the chord; the circulations G follow from the condition that at three quarters of
// each chord the air flows along the sail (Weissinger, NACA TM 1120, 1947):
//
//     sum over j of v_ij.n_i G_j = -W_i
//
// W_i is the head-on wind of the strip, weighted over the chord as thin plates do it (Glauert
// 1926), so that camber, twist and turning count. A strip gets the force of Kutta and Joukowski,
//
//     F_i = rho G_i (V_i - w_i u_i) x l_i
//
// with u_i across the wind and w_i the downwash of a wake that is plane far behind: for
// G = sum of a_k sin(k t), y = -b/2 cos t, it is w = 1/(2b) sum of k a_k sin(k t) / sin(t)
// (Glauert 1926), and the induced drag, its work, is never negative. That has suction at the
// leading edge and induced drag in it. The force acts at a quarter of the chord. How much more or
// less than the mean of its strip a panel meets the wind gives it 1/2 rho A (3 pi / 2) |w| dw
// across the wind, a pure moment: that of thin plates with parabolic camber.
//
// The sine of the angle at which a section meets the air is G / (pi c V). From 0.8 to 1.2 of the
// stall's the strip loses its circulation and gets the load of a plate (panel_load.h) instead;
// so does the whole wing when the wind comes at more than about 45 degrees to its chord. All in
// all the air gives no power: what a wing as a whole would gain from it is taken out as drag.
#pragma once

#include "laws/wing_strips.h"

namespace ripstop {

// What a panel of a wing is and meets, and its load.
struct WingPanel
{
    Vec3 normal = Vec3::Zero(); // m^2, twice the area long, by the order of its corners
    Vec3 wind = Vec3::Zero();   // m/s, that it meets
    double plate = 2.0;         // 1, Ca of the plate that it is when stalled
    double saturation = 0.0;    // 1, Ca / C90 - 1
    double stall = 0.25;        // 1, sine of the stall's angle
    bool gone = false;
    Vec3 load = Vec3::Zero(); // N, the answer: to be added to the plate's load

    // found on the way
    double size = 0.0;   // m^2, twice the area
    double headOn = 0.0; // m/s, the wind across the panel
    double held = 0.0;   // 1, share that is not stalled
    double more = 0.0;   // m/s, head-on wind beyond the mean of the strips, of that share
};

Vec3 plateLoad(const WingPanel& panel, double airDensity); // N

// Fills the loads of all panels of the wing; any thread may call it with panels of its own.
//   front, rear  m, where the cuts leave the edges now
//   panels       [wing.panels]
void fillWingLoads(const WingStrips& wing, const WingRim& front, const WingRim& rear,
                   double airDensity, std::span<WingPanel> panels);

} // namespace ripstop
