// At what links and panels tear, by the rule of their material:
//
//     rule        a link                                    a panel that carries the pull
//     length      above `tearLimit`, m                      never
//     strain      above `tearLimit`, 1                      the same, of its warp or weft threads
//     force       above `tearLimit`, N                      never
//     tension     a thread of a width w above               the pull per flat width of its warp or
//                 `tearLimit` w, N; others never            weft threads above `tearLimit`, N/m
//     strength    a line above `lineStrength`, N;           the same, above `warpStrength` or
//                 others never                              `weftStrength`, N/m
//     energy      the same                                  the same, but at the tip of a tear or a
//                                                           notch when that is driven on by more
//                                                           than the energy of `tearStrength`, N
//
// With the last two, a spar snaps above `breakingMoment`, N m, as well, and `jointEfficiency` is
// the share of all strengths that is left by the seams and knots of what the material is made into.
// What a link has as its own limit is in m, 1 or N; with the last three rules it is a force, N. A
// strength that is not there never breaks.
#pragma once

#include "laws/tear_limits.h"
#include "scene/items.h"

#include <optional>

namespace ripstop {

// What the material gives is times the strength factor of the link or the panel, but for lengths.
//
//   width   m, of the strip of fabric that the link stands for; 0 for none
//   factor  1, of what the material gives
TearLimit linkTearOf(const Material& material, LinkRole role, double width,
                     std::optional<double> own, double factor = 1.0);

// Whether a link that is drawn to this length, m, is beyond its limit. No length tells what a rod
// without compliance pulls with: by a force it never is.
bool isBeyondLimit(const Material& material, const Link& link, double length);

FabricTear fabricTearOf(const Material& material);

double shareLeftByJoints(const Material& material); // 1, of all its strengths

// J/m, of a tear that goes on. In the tongue test a force F pulls at either leg; for each length of
// tear the legs part by twice that, so that the tear takes up 2 F (Rivlin and Thomas 1953).
double tearEnergyOf(const Material& material);

double snapMomentOf(const Material& material); // N m, or 0 for never

} // namespace ripstop
