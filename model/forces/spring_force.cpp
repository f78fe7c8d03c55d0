#include "forces/spring_force.h"

#include "parallel/simd_pack.h"

#include <algorithm>
#include <cstdint>

namespace ripstop {
namespace {

struct SpringWork
{
    const Spring* springs;
    const std::uint8_t* torn;   // [springs]
    const PaddedVec3* position; // [particles] m
    const PaddedVec3* velocity; // [particles] m/s
    PaddedVec3* force;          // [springs] N, on end `a`
};

} // namespace
} // namespace ripstop

#define RIPSTOP_KERNEL "forces/spring_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

double springTension(const Spring& spring, const Vec3& separation, const Vec3& velocityDifference)
{
    return (wideMachine ? wide::tensionOf : anywhere::tensionOf)(spring, separation,
                                                                 velocityDifference);
}

bool isSlack(Resists resists, double stretch)
{
    return (resists == Resists::Tension && stretch < 0.0)
           || (resists == Resists::Compression && stretch > 0.0);
}

double elasticEnergy(double stiffness, Resists resists, double stretch)
{
    return isSlack(resists, stretch) ? 0.0 : 0.5 * stiffness * stretch * stretch;
}

void fillSpringForces(const System& system, const State& state, ThreadPool& pool,
                      std::span<PaddedVec3> force)
{
    fillSpringForces(system, state, pool, force, wideMachine);
}

void fillSpringForces(const System& system, const State& state, ThreadPool& pool,
                      std::span<PaddedVec3> force, bool asWide)
{
    const SpringWork work = {system.springs.data(), state.springTorn.data(), state.position.data(),
                             state.velocity.data(), force.data()};
    pool.parallelFor(system.springs.size(), [&](std::size_t first, std::size_t last) {
        (asWide ? wide::fillSprings : anywhere::fillSprings)(work, first, last);
    });
}

} // namespace ripstop
