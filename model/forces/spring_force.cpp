// Springs: the kernel that computes four at a time, and all that is asked of the force.
//
// The kernel (spring_kernel.inl) is compiled once for any machine and once for wide ones.
// fillSpringForces() runs it in parallel over the springs; SpringForce::prepare() notes at which of
// its particles a spring has its end `b`, which takes the opposite of the force. What follows
// (energy, power of dampers, work of pins) is asked for by measurements and goes over the springs
// one by one, in their order.
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

std::size_t at(int index) { return std::size_t(index); }

Vec3 unit(const Vec3& separation)
{
    const double length = separation.norm();
    return length > 0.0 ? Vec3(separation / length) : Vec3(Vec3::Zero());
}

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

SpringSum springsAt(const System& system, const State& state, std::size_t particle)
{
    SpringSum sum;
    for (int k = system.springsAt.start[particle]; k < system.springsAt.start[particle + 1]; ++k) {
        const auto spring = std::size_t(system.springsAt.items[std::size_t(k)]);
        if (state.springTorn[spring])
            continue;
        sum.stiffness += system.springs[spring].stiffness;
        sum.damping += system.springs[spring].damping;
    }
    return sum;
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

void SpringForce::prepare(const System& system, const State&)
{
    m_load.resize(system.springs.size());
    if (m_serial == system.serial)
        return;
    m_serial = system.serial;
    const Rows& rows = system.springsAt;
    m_isAtB.resize(rows.items.size());
    for (std::size_t p = 0; p + 1 < rows.start.size(); ++p)
        for (int k = rows.start[p]; k < rows.start[p + 1]; ++k)
            m_isAtB[at(k)] = system.springs[at(rows.items[at(k)])].a != int(p);
}

Lane SpringForce::fill(const System& system, const State& state, ThreadPool& pool)
{
    fillSpringForces(system, state, pool, m_load);
    return {.load = m_load.data(), .at = &system.springsAt, .minus = m_isAtB.data()};
}

double SpringForce::energy(const System& system, const State& state) const
{
    double energy = 0.0;
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const Spring& spring = system.springs[i];
        if (state.springTorn[i])
            continue;
        const double length = (state.position[at(spring.b)] - state.position[at(spring.a)]).norm();
        energy += elasticEnergy(spring.stiffness, spring.resists, length - spring.restLength);
    }
    return energy;
}

// Dampers take what the tension is beyond that of the stretch.
double SpringForce::dampingPower(const System& system, const State& state, ThreadPool& pool)
{
    fillSpringForces(system, state, pool, m_load);
    double power = 0.0;
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const Spring& spring = system.springs[i];
        if (state.springTorn[i] || spring.damping == 0.0)
            continue;
        const Vec3 separation = state.position[at(spring.b)] - state.position[at(spring.a)];
        const Vec3 apart = state.velocity[at(spring.b)] - state.velocity[at(spring.a)];
        const double length = separation.norm();
        if (!(length > 0.0))
            continue;
        const double stretch = length - spring.restLength;
        const double elastic = isSlack(spring.resists, stretch) ? 0.0 : spring.stiffness * stretch;
        const Vec3 along = separation / length;
        power -= (m_load[i].dot(along) - elastic) * apart.dot(along);
    }
    return power;
}

// Pins work against the springs as the substep has them: the pins have arrived and are as fast as
// they came, and all else is where it was at its start.
double SpringForce::workOfPins(const System& system, const State& state,
                               const MotionBefore& before) const
{
    const auto isPinned = [&](int particle) { return system.inverseMass[at(particle)] == 0.0; };
    const auto placeOf = [&](int particle) -> Vec3 {
        return isPinned(particle) ? state.position[at(particle)] : before.position[at(particle)];
    };
    const auto velocityOf = [&](int particle) -> Vec3 {
        return isPinned(particle) ? state.velocity[at(particle)] : before.velocity[at(particle)];
    };
    double work = 0.0;
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const Spring& spring = system.springs[i];
        if (state.springTorn[i] || !(isPinned(spring.a) || isPinned(spring.b)))
            continue;
        const Vec3 separation = placeOf(spring.b) - placeOf(spring.a);
        const Vec3 was = before.position[at(spring.b)] - before.position[at(spring.a)];
        const Vec3 apart = velocityOf(spring.b) - velocityOf(spring.a);
        work += springTension(spring, separation, apart) * unit(separation).dot(separation - was);
    }
    return work;
}

void SpringForce::addStiffness(const System& system, std::span<double> stiffness,
                               std::span<double> damping) const
{
    for (const Spring& spring : system.springs)
        for (const int end : {spring.a, spring.b}) {
            stiffness[at(end)] += spring.stiffness;
            damping[at(end)] += spring.damping;
        }
}

std::unique_ptr<Force> SpringLists::makeForce() { return std::make_unique<SpringForce>(); }

} // namespace ripstop
