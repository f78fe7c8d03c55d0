// The pull of a hand on a few particles.
//
// findGrip() looks up the particles of a grip, once for a system. handForce() finds the point, the
// velocity and the mass in the grip, lowers the stiffness to what the springs there leave of the
// limit of the step (roomAt, largestPhase), adds damping and keeps the force below what the hand
// can give. addHandPull() shares it out. HandPullForce at the end makes a Force of this: as it acts
// on three particles at most it adds to the sum of the others, and its work is the mean of the
// forces at both ends of the way times that way.
#include "forces/hand_pull.h"

#include "forces/force.h"
#include "forces/spring_force.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// What the springs at a particle leave of (h w)^2 + 2 h c < 4, with a margin; where they leave
// nothing, a hand may still pull a little.
double roomAt(const System& system, const State& state, std::size_t particle, double h)
{
    constexpr double whole = 3.5, least = 0.5;
    const auto [stiffness, damping] = springsAt(system, state, particle);
    const double w = system.inverseMass[particle];
    return std::max(whole - w * h * (2.0 * stiffness * h + 4.0 * damping), least);
}

// The largest x = h sqrt(k / m) with x^2 + 4 z x / (1 + 2 z x) <= room.
double largestPhase(double room, double z)
{
    const double always = std::sqrt(4.0 * z * z + room) - 2.0 * z; // x^2 + 4 z x = room
    return room > 2.0 ? std::max(always, std::sqrt(room - 2.0)) : always;
}

} // namespace

bool HeldGrip::holds() const
{
    for (std::size_t i = 0; i < 3; ++i)
        if (grip.share[Eigen::Index(i)] != 0.0 && particle[i] < 0)
            return false;
    return serial != 0;
}

HeldGrip findGrip(const System& system, const Grip& grip)
{
    HeldGrip held{grip, {-1, -1, -1}, system.serial};
    for (std::size_t i = 0; i < 3; ++i) {
        if (grip.share[Eigen::Index(i)] == 0.0)
            continue;
        const auto found = std::find(system.key.begin(), system.key.end(), grip.particle[i]);
        if (found != system.key.end())
            held.particle[i] = int(found - system.key.begin());
    }
    return held;
}

HandForce handForce(const System& system, const State& state, const HandPull& pull,
                    const HeldGrip& held, double h)
{
    HandForce result;
    if (!held.holds())
        return result;
    Vec3 velocity = Vec3::Zero();
    double perMass = 0.0; // 1/kg
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = pull.grip.share[Eigen::Index(i)];
        if (share == 0.0)
            continue;
        const auto p = std::size_t(held.particle[i]);
        result.point += share * state.position[p];
        velocity += share * state.velocity[p];
        perMass += share * share * system.inverseMass[p];
    }
    double stiffness = pull.stiffness;
    double damping = 0.0; // N s/m
    if (perMass > 0.0) {
        double load = 0.0; // 1, the phase of the grip that would fill the room of a particle
        for (std::size_t i = 0; i < 3; ++i) {
            const double share = std::abs(pull.grip.share[Eigen::Index(i)]);
            if (share == 0.0)
                continue;
            const auto p = std::size_t(held.particle[i]);
            const double room = roomAt(system, state, p, h);
            load = std::max(load, share * system.inverseMass[p] / perMass / room);
        }
        const double phase = load > 0.0 ? largestPhase(1.0 / load, pull.damping) : 0.0;
        stiffness = std::min(stiffness, phase * phase / (h * h * perMass));
        const double critical = 2.0 * pull.damping * std::sqrt(stiffness / perMass);
        damping = critical / (1.0 + h * critical * perMass);
    }
    result.stiffness = stiffness;
    result.force = stiffness * (pull.to - result.point) - damping * velocity;
    if (const double strength = result.force.norm(); strength > pull.most)
        result.force *= pull.most / strength;
    return result;
}

void addHandPull(const System& system, const State& state, const HeldGrip& held, double h,
                 std::span<PaddedVec3> acceleration)
{
    const HandPull& pull = *state.hands.pull;
    const Vec3 force = handForce(system, state, pull, held, h).force;
    for (std::size_t i = 0; i < 3; ++i)
        if (held.holds() && pull.grip.share[Eigen::Index(i)] != 0.0) {
            const auto p = std::size_t(held.particle[i]);
            acceleration[p] += (pull.grip.share[Eigen::Index(i)] * system.inverseMass[p]) * force;
        }
}

namespace {

class HandPullForce final : public Force
{
public:
    Message name() const override { return Message("hand"); }
    ForceKind kind() const override { return ForceKind::Hand; }
    bool acts(const System&, const State& state) const override
    {
        return state.hands.pull.has_value();
    }
    void prepare(const System& system, const State& state) override
    {
        if (const auto& pull = state.hands.pull; pull && !m_grip.isOf(system, pull->grip))
            m_grip = findGrip(system, pull->grip);
    }
    void addToFew(const System& system, const State& state, double h,
                  std::span<PaddedVec3> acceleration) override
    {
        addHandPull(system, state, m_grip, h, acceleration);
    }
    void startWork(const System& system, const State& state, double h) override
    {
        m_last = handForce(system, state, *state.hands.pull, m_grip, h);
    }
    double workSince(const System& system, const State& state, double h) override
    {
        const HandForce now = handForce(system, state, *state.hands.pull, m_grip, h);
        const double work =
            m_grip.holds() ? 0.5 * (m_last.force + now.force).dot(now.point - m_last.point) : 0.0;
        m_last = now;
        return work;
    }

private:
    HeldGrip m_grip;
    HandForce m_last; // when its work was last asked for
};

} // namespace

std::unique_ptr<Force> HandLists::makeForce() { return std::make_unique<HandPullForce>(); }

} // namespace ripstop
