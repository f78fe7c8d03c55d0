#include "sim/stepper.h"

#include "sim/contact.h"
#include "sim/inputs.h"
#include "sim/panel_load.h"
#include "sim/particle_motion.h"
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
    m_keep = std::exp(-system.viscosity * system.timeStep / system.substeps);
    m_rods.start(system, state.rodTension);
    m_tearsByForce = std::any_of(system.tearable.begin(), system.tearable.end(), [&](int link) {
        const LinkPlace& place = system.links[std::size_t(link)];
        return place.kind == LinkKind::Rod
               && system.rods[std::size_t(place.index)].tear.rule == TearRule::Force;
    });
}

void Stepper::substep(const System& system, State& state, double h, std::uint64_t number)
{
    if (moveInputs(system, state, h))
        shiftRestLengths(system, state, m_restLength);
    fillAccelerations(system, state);
    move(ParticlePass::Predict, system, state, h);
    noteRodLengths(system, state);
    project(system, state, h, number);
    if (system.integrator == Integrator::VelocityVerlet) {
        move(ParticlePass::ForeseeVelocities, system, state, h);
        fillAccelerations(system, state);
    }
    move(ParticlePass::FollowRods, system, state, h);
    resolveContacts(system, state, m_before, h, m_crew);
    tearLinks(system, state, m_rodLength, m_springForce, m_restLength);
    state.started = true;
}

void Stepper::fillAccelerations(const System& system, const State& state)
{
    fillSpringForces(system, state, m_crew, m_springForce);
    fillPanelLoads(system, state, m_crew, m_panelLoad);
    m_crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        gatherAccelerations(system, {m_springForce.data(), m_panelLoad.data()},
                            m_acceleration.data(), first, last);
    });
}

void Stepper::move(ParticlePass pass, const System& system, State& state, double h)
{
    const ParticleMotion motion{state.position.data(),
                                state.velocity.data(),
                                state.drift.data(),
                                m_before.data(),
                                m_predicted.data(),
                                m_acceleration.data(),
                                system.inverseMass.data(),
                                h,
                                m_keep,
                                state.started};
    m_crew.each(state.position.size(), [&](std::size_t first, std::size_t last) {
        runPass(pass, system.integrator, motion, first, last);
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

} // namespace ripstop
