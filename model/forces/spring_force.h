// Forces of springs: F = k (|d| - l) + nu (vb - va).u along u = d/|d|, d = xb - xa, on `a` towards
// `b` and the opposite on `b`. A spring that resists tension only is slack when short and never
// pushes; one that resists compression only never pulls.
#pragma once

#include "forces/force.h"

#include <span>
#include <vector>

namespace ripstop {

// Force along the spring, N, positive when it pulls its ends together; 0 when slack or coincident.
double springTension(const Spring& spring, const Vec3& separation, const Vec3& velocityDifference);

// What the springs that are whole and end at a particle come to together.
struct SpringSum
{
    double stiffness = 0.0; // N/m
    double damping = 0.0;   // N s/m
};
SpringSum springsAt(const System& system, const State& state, std::size_t particle);

// Energy of a spring, or of a rod that gives way, J: it stores some only where it resists.
double elasticEnergy(double stiffness, Resists resists, double stretch);

// Force of every spring, zero where it is torn.
//   force  [springs]  N, on end `a`
void fillSpringForces(const System& system, const State& state, ThreadPool& pool,
                      std::span<PaddedVec3> force);

// fillSpringForces() that is told whether to use the kernel for wide machines (simd_pack.h), which
// must not be asked of another machine. Both ways give the same bits, which tests compare.
void fillSpringForces(const System& system, const State& state, ThreadPool& pool,
                      std::span<PaddedVec3> force, bool wide);

// The force of all springs of a system. Tearing looks at what it was at the last fill().
class SpringForce final : public Force
{
public:
    // N, on end `a`, as of the last fill()
    std::span<const PaddedVec3> loads() const { return m_load; }

    Message name() const override { return Message("springs"); }
    ForceKind kind() const override { return ForceKind::Elastic; }
    bool acts(const System& system, const State&) const override { return !system.springs.empty(); }
    void prepare(const System& system, const State&) override;
    Lane fill(const System& system, const State& state, ThreadPool& pool) override;
    double energy(const System& system, const State& state) const override;
    double dampingPower(const System& system, const State& state, ThreadPool& pool) override;
    double workOfPins(const System& system, const State& state,
                      const MotionBefore& before) const override;
    void addStiffness(const System& system, std::span<double> stiffness,
                      std::span<double> damping) const override;

private:
    std::vector<PaddedVec3> m_load;    // [springs] N, on end `a`
    std::vector<std::uint8_t> m_isAtB; // [springsAt.items] 1 where the particle is end `b`
    std::uint64_t m_serial = 0;        // of the system that m_isAtB is of
};

} // namespace ripstop
