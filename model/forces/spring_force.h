// Forces of springs: F = k (|d| - l) + nu (vb - va).u along u = d/|d|, d = xb - xa, on `a` towards
// `b` and the opposite on `b`. A spring that resists tension only is slack when short and never
// pushes; one that resists compression only never pulls.
#pragma once

#include "parallel/thread_pool.h"
#include "system/system.h"

#include <span>

namespace ripstop {

// Force along the spring, N, positive when it pulls its ends together; 0 when torn or coincident.
double springTension(const Spring& spring, const Vec3& separation, const Vec3& velocityDifference);

// Whether what resists this does not resist this stretch, m.
bool isSlack(Resists resists, double stretch);

// J. A spring, or a rod that gives way, stores energy only where it resists.
double elasticEnergy(double stiffness, Resists resists, double stretch);

//   force  [springs]  N, on end `a`
void fillSpringForces(const System& system, const State& state, ThreadPool& pool,
                      std::span<PaddedVec3> force);

// The same, told whether the machine is wide (simd_pack.h), which must not be said of one that is
// not; both ways give the same bits.
void fillSpringForces(const System& system, const State& state, ThreadPool& pool,
                      std::span<PaddedVec3> force, bool wide);

} // namespace ripstop
