// Damping of rods that stretch: Kelvin and Voigt's solid, a spring and a damper side by side.
//
// A rod of compliance c and damping time t pulls with (C + t C') / c, C being its stretch. Over a
// substep that reaches back by k (step/particle_motion.h), C' = (C - B) / k, where B is the stretch
// that the integrator looks back to: of the start for implicit Euler, (4 C1 - C2) / 3 of the last
// two substeps for BDF2. So the pull is
//
//     (C - r B) / (c (1 - r)),      r = t / (t + k),
//
// that of a rod without damping whose rest length is longer by r B and whose compliance is smaller
// by 1 - r: every solver damps by being given those, implicitly, and nothing bounds the substep.
// What is slack has no damper: its stretch counts from 0 when it gets tight. For implicit Euler B
// is then 0. BDF2 would take the kink for half as much speed again, so that it looks back to a
// third of where the ends would be if they went on, (2 C1 - C2) / 3, or 0.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

// c (1 - r) above, m/N; c where the reach is infinite.
double complianceOver(const Rod& rod, double reach);

// Where the substep begins, and what it looks back to.
struct RodPast
{
    std::span<const PaddedVec3> before; // [particles] m, at its start
    std::span<const PaddedVec3> drift;  // [particles] m/s, of BDF2 that looks back; otherwise empty
    double h;                           // s, the substep
    double reach;                       // s
};

class RodDamping
{
public:
    // Finds the rods that are damped; before the substeps of a step.
    void prepare(const System& system);

    // Indices of the rods that are damped, ascending.
    std::span<const int> rods() const { return m_rods; }

    // The rest lengths that solvers are to hold in a substep, m; where nothing is damped those that
    // are given. They stay as they are until the next call.
    std::span<const double> lengthsFor(const System& system, std::span<const double> restLength,
                                       const RodPast& past, ThreadPool& pool);

private:
    std::vector<int> m_rods;
    std::vector<double> m_length; // [rods] m, or empty
    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
};

} // namespace ripstop
