#include "sim/stepper.h"

#include "sim/contact.h"
#include "sim/inputs.h"
#include "sim/panel_load.h"
#include "sim/spring_force.h"
#include "sim/tearing.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

void Stepper::step(const System& system, State& state)
{
    prepare(system, state);
    const double h = system.timeStep / system.substeps;
    const double startTime = state.time;
    for (int s = 0; s < system.substeps; ++s) {
        state.time = startTime + (s + 1) * h;
        substep(system, state, h,
                std::uint64_t(state.step) * std::uint64_t(system.substeps) + std::uint64_t(s));
    }
    m_rods.takeTensions(system, h, state.rodTension);
    ++state.step;
}

void Stepper::prepare(const System& system, State& state)
{
    m_springForce.resize(system.springs.size());
    m_panelLoad.resize(system.panels.size());
    m_acceleration.resize(state.position.size());
    m_before.resize(state.position.size());
    m_predicted.resize(state.position.size());
    m_restLength.resize(system.rods.size());
    m_rodLength.resize(system.rods.size());
    fillRestLengths(system, state, m_restLength);
    m_rods.start(system, state.rodTension);
    m_tearsByForce = std::any_of(system.tearable.begin(), system.tearable.end(), [&](int link) {
        const LinkPlace& place = system.links[std::size_t(link)];
        return place.kind == LinkKind::Rod
               && system.rods[std::size_t(place.index)].tear.rule == TearRule::Force;
    });
}

void Stepper::substep(const System& system, State& state, double h, std::uint64_t number)
{
    moveInputs(system, state, h);
    if (!system.shiftedRods.empty())
        fillRestLengths(system, state, m_restLength);
    fillAccelerations(system, state);
    predict(system, state, h);
    noteRodLengths(system, state);
    project(system, state, h, number);
    updateVelocities(system, state, h);
    resolveContacts(system, state, m_before, h, m_crew);
    tearLinks(system, state, m_rodLength, m_springForce, m_restLength);
    state.started = true;
}

// Forces are computed per element and gathered per particle in the order of the elements, so that
// sums do not depend on who computed what when.
void Stepper::fillAccelerations(const System& system, const State& state)
{
    fillSpringForces(system, state, m_crew, m_springForce);
    fillPanelLoads(system, state, m_crew, m_panelLoad);

    m_crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            m_acceleration[i].setZero();
            if (system.inverseMass[i] == 0.0)
                continue;
            Vec3 force = Vec3::Zero();
            for (int k = system.springsAt.start[i]; k < system.springsAt.start[i + 1]; ++k) {
                const auto spring = std::size_t(system.springsAt.items[std::size_t(k)]);
                if (std::size_t(system.springs[spring].a) == i)
                    force += m_springForce[spring];
                else
                    force -= m_springForce[spring];
            }
            Vec3 air = Vec3::Zero();
            for (int k = system.panelsAt.start[i]; k < system.panelsAt.start[i + 1]; ++k)
                air += m_panelLoad[std::size_t(system.panelsAt.items[std::size_t(k)])];
            force += air / 3.0;
            m_acceleration[i] = system.gravity + system.inverseMass[i] * force;
        }
    });
}

void Stepper::predict(const System& system, State& state, double h)
{
    m_crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Vec3& x = state.position[i];
            Vec3& v = state.velocity[i];
            Vec3& drift = state.drift[i];
            const Vec3& a = m_acceleration[i];
            m_before[i] = x;
            if (system.inverseMass[i] == 0.0) {
                v.setZero();
                drift.setZero();
                m_predicted[i] = x;
                continue;
            }
            switch (system.integrator) {
            case Integrator::ExplicitEuler:
                x += h * v;
                v += h * a;
                break;
            case Integrator::SemiImplicitEuler:
                v += h * a;
                x += h * v;
                break;
            case Integrator::Verlet:
            case Integrator::VelocityVerlet:
                // x' = 2 x - previous + a h^2, Verlet 1967, with (x - previous) / h remembered
                // instead of the previous position, which would lose digits far from the origin.
                // The start previous = x - v h + a h^2 / 2 keeps it of second order. Velocity
                // Verlet goes the same way; from v at a full step it would count only half of the
                // acceleration of what rods hold.
                if (!state.started)
                    drift = v - (0.5 * h) * a;
                drift += h * a;
                x += h * drift;
                break;
            }
            m_predicted[i] = x;
        }
    });
}

void Stepper::noteRodLengths(const System& system, const State& state)
{
    if (system.tearable.empty())
        return;
    for (std::size_t i = 0; i < system.rods.size(); ++i)
        m_rodLength[i] = (state.position[std::size_t(system.rods[i].b)]
                          - state.position[std::size_t(system.rods[i].a)])
                             .norm();
}

void Stepper::project(const System& system, State& state, double h, std::uint64_t number)
{
    m_rods.project({system, state.rodTorn, m_restLength, h, number, state.position}, m_crew);
    if (m_tearsByForce)
        m_rods.takeTensions(system, h, state.rodTension);
}

// Velocities take over what the rods did to the positions.
void Stepper::updateVelocities(const System& system, State& state, double h)
{
    const double keep = std::exp(-system.viscosity * h);
    const bool verlet = system.integrator == Integrator::Verlet;
    const bool second = system.integrator == Integrator::VelocityVerlet;
    const auto correctionOf = [&](std::size_t i) -> Vec3 {
        return state.position[i] - m_predicted[i];
    };
    if (second) {
        // Drag and dampers keep the scheme of second order only if they see the velocity of the
        // end of the step; for what rods hold, that is the way it went.
        m_crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const Vec3 correction = correctionOf(i);
                state.velocity[i] = state.drift[i]
                                    + (correction.isZero(0.0) ? Vec3((0.5 * h) * m_acceleration[i])
                                                              : Vec3(correction / h));
            }
        });
        fillAccelerations(system, state);
    }

    m_crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (system.inverseMass[i] == 0.0)
                continue;
            Vec3& v = state.velocity[i];
            const Vec3 correction = correctionOf(i);
            if (verlet || second) {
                // The half step of acceleration that turns the drift into the velocity of now is
                // right for free motion only: at rest in a rod it would read as a fall.
                state.drift[i] += correction / h;
                v = state.drift[i];
                if (correction.isZero(0.0))
                    v += (0.5 * h) * m_acceleration[i];
            } else {
                v += correction / h;
            }
            v *= keep;
            state.drift[i] *= keep;
        }
    });
}

} // namespace ripstop
