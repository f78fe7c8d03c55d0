// The ledger looks at positions, velocities and forces at both ends of each substep, adds the work
// between them, and at the end of the step takes it from the change of energy.
#include "measure/energy_ledger.h"

#include "forces/bend_force.h"
#include "measure/diagnostics.h"
#include "step/inputs.h"
#include "system/membrane.h"

#include <algorithm>

namespace ripstop {
namespace {

std::size_t at(int index) { return std::size_t(index); }

Vec3 unit(const Vec3& separation)
{
    const double length = separation.norm();
    return length > 0.0 ? Vec3(separation / length) : Vec3(Vec3::Zero());
}

bool movesPins(const System& system)
{
    return std::ranges::any_of(system.inputs, [&](const Input& input) {
        return input.kind == ControlKind::Move
               && std::ranges::any_of(input.targets, [&](int target) {
                      return system.inverseMass[at(target)] == 0.0;
                  });
    });
}

} // namespace

bool isOfLedger(Quantity quantity)
{
    return quantity >= Quantity::WorkOfAir && quantity <= Quantity::EnergyResidual;
}

bool wantsLedger(const System& system)
{
    return std::ranges::any_of(system.probes,
                               [](const ProbeSpec& probe) { return isOfLedger(probe.quantity); });
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
    for (const auto& force : m_forces) {
        force->prepare(system, state);
        if (force->acts(system, state))
            force->startWork(system, state, h);
    }
    look(system, state, m_before);
}

void EnergyLedger::look(const System& system, const State& state, Instant& instant)
{
    instant.position.assign(state.position.begin(), state.position.end());
    instant.velocity.assign(state.velocity.begin(), state.velocity.end());
    instant.hasPast = state.driftSubstep > 0.0;
    lookAtForces(system, state, instant);
    if (movesPins(system) && !system.of<BendLists>().list.empty())
        instant.bending = pullsOfBends(system, state);
    else
        instant.bending.clear();
}

void EnergyLedger::lookAtForces(const System& system, const State& state, Instant& instant)
{
    instant.air.assign(state.position.size(), Vec3::Zero());
    instant.damping = 0.0;
    for (const auto& force : m_forces) {
        if (!force->acts(system, state))
            continue;
        switch (force->kind()) {
        case ForceKind::Air:
            addForces(force->fill(system, state, m_alone), instant.air);
            break;
        case ForceKind::Elastic:
        case ForceKind::Weight:
            instant.damping += force->dampingPower(system, state, m_alone);
            break;
        case ForceKind::Hand:
            break; // addWorkOfHands()
        }
    }
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

// What was solved is no change of velocity that contact makes afterwards. By BDF2 a push reaches as
// far as two thirds of the substep, and acts in all of it.
void EnergyLedger::afterSolve(std::span<const HeldContact> contacts, double h, double reach)
{
    for (const HeldContact& contact : contacts)
        m_contact[std::size_t(contact.particle)] += h / (reach * reach) * contact.push();
}

void EnergyLedger::afterSubstep(const System& system, const State& state, double h,
                                Integrator integrator)
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
    m_work.damping += workOfDampers(system, state, h);
    addWorkOfHands(system, state, h, integrator);
    m_work.hands += workOnPanels(system, state, h);
    m_work.hands += workOnBends(system);
    m_contact.clear();
    std::swap(m_before, m_after);
}

// J, by the mean rate of each stretch (constraints/rod_damping.h).
double EnergyLedger::workOfDampers(const System& system, const State& state, double h) const
{
    double work = 0.0;
    for (std::size_t r = 0; r < system.rods.size(); ++r) {
        const Rod& rod = system.rods[r];
        if (rod.dampingTime == 0.0 || rod.compliance == 0.0 || state.rodTorn[r])
            continue;
        const auto stretch = [&](const Instant& instant) {
            const double longer = (instant.position[at(rod.b)] - instant.position[at(rod.a)]).norm()
                                  - m_restLength[r];
            return isSlack(rod.resists, longer) ? 0.0 : longer;
        };
        const double change = stretch(m_after) - stretch(m_before);
        work -= rod.dampingTime / rod.compliance * change * change / h;
    }
    for (const Membrane& membrane : system.membranes)
        if (!state.panelGone[at(membrane.panel)])
            work -= lossIn(system, membrane, cornersOf(system, membrane, m_before.position),
                           cornersOf(system, membrane, m_after.position), h);
    return work;
}

// Forces of BDF2 see what will be at the end of the substep, as far as that is known at its start.
void EnergyLedger::addWorkOfHands(const System& system, const State& state, double h,
                                  Integrator integrator)
{
    m_seen = m_before.position;
    if (integrator == Integrator::Bdf2 && m_before.hasPast)
        for (std::size_t i = 0; i < m_seen.size(); ++i)
            if (system.inverseMass[i] > 0.0)
                m_seen[i] += h * m_before.velocity[i];
    for (const auto& force : m_forces)
        if (force->acts(system, state)) {
            m_work.hands += force->workOfPins(system, state, {m_seen, m_before.velocity});
            m_work.hands += force->workSince(system, state, h);
        }
}

// J, by what moves their pinned corners in a substep.
double EnergyLedger::workOnPanels(const System& system, const State& state, double h) const
{
    double work = 0.0;
    for (const Membrane& membrane : system.membranes) {
        const std::array<int, 3>& corner = system.panels[at(membrane.panel)].corner;
        Corners way;
        bool moves = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t p = at(corner[k]);
            const bool isPin = system.inverseMass[p] == 0.0;
            way[k] = isPin ? Vec3(m_after.position[p] - m_before.position[p]) : Vec3(Vec3::Zero());
            moves |= !way[k].isZero(0.0);
        }
        if (!moves || state.panelGone[at(membrane.panel)])
            continue;
        const Corners from = cornersOf(system, membrane, m_before.position);
        const Corners to = cornersOf(system, membrane, m_after.position);
        const Corners first = pullsOnCorners(system, membrane, from);
        const Corners last = pullsOnCorners(system, membrane, to);
        const Corners damping = dampingPulls(system, membrane, from, to, h);
        for (std::size_t k = 0; k < 3; ++k)
            work -= (0.5 * (first[k] + last[k]) + damping[k]).dot(way[k]);
    }
    return work;
}

// J, by what moves pins that bend something in a substep.
double EnergyLedger::workOnBends(const System& system) const
{
    double work = 0.0;
    for (std::size_t p = 0; p < m_after.bending.size(); ++p)
        if (system.inverseMass[p] == 0.0)
            work -= 0.5
                    * (m_before.bending[p] + m_after.bending[p])
                          .dot(m_after.position[p] - m_before.position[p]);
    return work;
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
