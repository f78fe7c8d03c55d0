#include "measure/energy_ledger.h"

#include "forces/canopy_air.h"
#include "forces/line_drag.h"
#include "forces/panel_load.h"
#include "forces/spring_force.h"
#include "measure/diagnostics.h"
#include "step/inputs.h"

#include <algorithm>

namespace ripstop {
namespace {

std::size_t at(int index) { return std::size_t(index); }

Vec3 unit(const Vec3& separation)
{
    const double length = separation.norm();
    return length > 0.0 ? Vec3(separation / length) : Vec3(Vec3::Zero());
}

} // namespace

bool wantsLedger(const System& system)
{
    return std::ranges::any_of(system.probes, [](const ProbeSpec& probe) {
        return probe.quantity >= Quantity::WorkOfAir && probe.quantity <= Quantity::EnergyResidual;
    });
}

// N on each particle, of panels and lines.
void EnergyLedger::gatherAir(const System& system, const State& state, std::vector<Vec3>& force)
{
    m_loads.resize(system.panels.size());
    m_drags.resize(system.dragLines.size());
    fillPanelLoads(system, state, m_alone, m_loads);
    m_wings.add(system, state, m_loads);
    addCanopyLoads(system, state, m_alone, m_loads);
    fillLineDrags(system, state, m_alone, m_drags);
    force.assign(state.position.size(), Vec3::Zero());
    for (std::size_t i = 0; i < m_loads.size(); ++i)
        for (const int corner : system.panels[i].corner)
            force[at(corner)] += m_loads[i] / 3.0;
    for (std::size_t i = 0; i < m_drags.size(); ++i) {
        force[at(system.dragLines[i].a)] += m_drags[i] / 2.0;
        force[at(system.dragLines[i].b)] += m_drags[i] / 2.0;
    }
}

void EnergyLedger::begin(const System& system, const State& state, double h)
{
    m_work = {};
    m_tears = state.tears.size();
    m_stepStart = state.position;
    m_restLength.resize(system.rods.size());
    m_restLengthAfter.resize(system.rods.size());
    fillRestLengths(system, state, m_restLength);
    m_energy = energies(system, state, m_restLength).total();
    m_contact.clear();
    look(system, state, m_before);
    if (const auto& pull = state.hands.pull) {
        if (!m_grip.isOf(system, pull->grip))
            m_grip = findGrip(system, pull->grip);
        const HandForce hand = handForce(system, state, *pull, m_grip, h);
        m_held = hand.point;
        m_pull = hand.force;
    }
}

void EnergyLedger::look(const System& system, const State& state, Instant& instant)
{
    instant.position.assign(state.position.begin(), state.position.end());
    instant.velocity.assign(state.velocity.begin(), state.velocity.end());
    gatherAir(system, state, instant.air);
    instant.damping = dampingPower(system, state);
}

// W, of dampers in springs: what their tension is beyond that of the stretch.
double EnergyLedger::dampingPower(const System& system, const State& state)
{
    m_springs.resize(system.springs.size());
    fillSpringForces(system, state, m_alone, m_springs);
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
        power -= (m_springs[i].dot(along) - elastic) * apart.dot(along);
    }
    return power;
}

// J, by what has moved pinned ends, against the springs as the substep has them: the pins are
// there, and all else is where it was at its start.
double EnergyLedger::workOnSprings(const System& system, const State& state) const
{
    const auto isPinned = [&](int particle) { return system.inverseMass[at(particle)] == 0.0; };
    const auto placeOf = [&](int particle) -> Vec3 {
        return isPinned(particle) ? state.position[at(particle)] : m_before.position[at(particle)];
    };
    double work = 0.0;
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const Spring& spring = system.springs[i];
        if (state.springTorn[i] || !(isPinned(spring.a) || isPinned(spring.b)))
            continue;
        const Vec3 separation = placeOf(spring.b) - placeOf(spring.a);
        const Vec3 before = m_before.position[at(spring.b)] - m_before.position[at(spring.a)];
        const Vec3 apart = m_before.velocity[at(spring.b)] - m_before.velocity[at(spring.a)];
        work +=
            springTension(spring, separation, apart) * unit(separation).dot(separation - before);
    }
    return work;
}

void EnergyLedger::beforeContact(const System&, const State& state)
{
    m_beforeContact.assign(state.velocity.begin(), state.velocity.end());
}

void EnergyLedger::afterContact(const System& system, const State& state)
{
    m_contact.resize(state.velocity.size());
    for (std::size_t i = 0; i < m_contact.size(); ++i)
        m_contact[i] = system.mass[i] * (state.velocity[i] - m_beforeContact[i]);
}

void EnergyLedger::afterSubstep(const System& system, const State& state, double h)
{
    look(system, state, m_after);
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        if (system.inverseMass[i] == 0.0)
            continue;
        const Vec3 velocity = 0.5 * (m_before.velocity[i] + m_after.velocity[i]);
        m_work.air += 0.5 * h * (m_before.air[i] + m_after.air[i]).dot(velocity);
        m_work.damping -= h * system.viscosity * system.mass[i] * velocity.squaredNorm();
        if (!m_contact.empty())
            m_work.contact += m_contact[i].dot(velocity);
    }
    m_work.damping += 0.5 * h * (m_before.damping + m_after.damping);
    m_work.hands += workOnSprings(system, state);
    if (state.hands.pull)
        addHandPull(system, state, h);
    m_contact.clear();
    std::swap(m_before, m_after);
}

void EnergyLedger::addHandPull(const System& system, const State& state, double h)
{
    const HandForce hand = handForce(system, state, *state.hands.pull, m_grip, h);
    if (m_grip.holds())
        m_work.hands += 0.5 * (m_pull + hand.force).dot(hand.point - m_held);
    m_held = hand.point;
    m_pull = hand.force;
}

// J, by what moves their pinned ends and changes their lengths.
double EnergyLedger::workOnRods(const System& system, const State& state) const
{
    double work = 0.0;
    for (std::size_t i = 0; i < system.rods.size(); ++i) {
        const Rod& rod = system.rods[i];
        const std::size_t a = at(rod.a);
        const std::size_t b = at(rod.b);
        const auto wayOf = [&](std::size_t end) {
            return system.inverseMass[end] == 0.0 ? Vec3(state.position[end] - m_stepStart[end])
                                                  : Vec3(Vec3::Zero());
        };
        const Vec3 along = unit(unit(m_stepStart[b] - m_stepStart[a])
                                + unit(state.position[b] - state.position[a]));
        const double longer =
            along.dot(wayOf(b) - wayOf(a)) - (m_restLengthAfter[i] - m_restLength[i]);
        work += state.rodTension[i] * longer;
    }
    return work;
}

void EnergyLedger::end(const System& system, State& state)
{
    fillRestLengths(system, state, m_restLengthAfter);
    m_work.hands += workOnRods(system, state);
    for (std::size_t i = m_tears; i < state.tears.size(); ++i)
        m_work.tearing -= state.tears[i].energy;
    const double change = energies(system, state, m_restLengthAfter).total() - m_energy;
    m_work.residual =
        change - (m_work.air + m_work.hands + m_work.damping + m_work.contact + m_work.tearing);
    state.work.air += m_work.air;
    state.work.hands += m_work.hands;
    state.work.damping += m_work.damping;
    state.work.contact += m_work.contact;
    state.work.tearing += m_work.tearing;
    state.work.residual += m_work.residual;
}

} // namespace ripstop
