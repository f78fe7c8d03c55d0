// Wind on lines.
//
//     F = 1/2 rho Cd d l |t| t,  t = w - (w.u) u
//
// u is the line's direction, l its length, d its diameter and w the apparent wind: that at the
// middle of the line less the mean velocity of the ends. Only the part across the line counts
// (the independence principle, Hoerner 1965, chapter 3); Cd is 1 to 1.1 for Reynolds numbers of 1e3
// to 1e5. Each end carries half of F. A torn line has none.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// Drag of a line from `a` to `b`, N; `width` is Cd d, m.
Vec3 lineDrag(double width, const Vec3& a, const Vec3& b, const Vec3& apparentWind,
              double airDensity);

// Drag of every line, N.
//   drag  [lines]  N
void fillLineDrags(const System& system, const State& state, ThreadPool& pool,
                   std::span<PaddedVec3> drag);

} // namespace ripstop
