#include "run/simulation.h"

#include "measure/diagnostics.h"
#include "measure/probe.h"
#include "sim/carry_over.h"
#include "sim/obstacle_motion.h"
#include "sim/wind.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

std::shared_ptr<const Layout> layoutOf(const System& system)
{
    auto layout = std::make_shared<Layout>();
    layout->particleId = system.key;
    layout->pinned.reserve(system.inverseMass.size());
    layout->links.reserve(system.links.size());
    layout->panelCorners.reserve(system.panels.size());
    for (const double w : system.inverseMass)
        layout->pinned.push_back(w == 0.0);
    for (const LinkPlace& link : system.links)
        layout->links.push_back({link.key, link.kind, link.a, link.b,
                                 link.kind == LinkKind::Rod
                                     ? system.rods[std::size_t(link.index)].restLength
                                     : system.springs[std::size_t(link.index)].restLength});
    layout->panelId = system.panelKey;
    for (const FabricPanel& panel : system.panels)
        layout->panelCorners.push_back(panel.corner);
    for (const Input& input : system.inputs)
        layout->inputId.push_back(input.key);
    for (const Obstacle& obstacle : system.obstacles)
        layout->colliderId.push_back(obstacle.key);
    for (const ProbeSpec& probe : system.probes)
        layout->probes.push_back(
            {probe.key, probe.name, std::string(unitOf(probe.quantity)), probe.plotted});
    return layout;
}

} // namespace

bool hasReached(double time, double until, double timeStep)
{
    return time >= until - (0.5 + 1e-6) * timeStep;
}

Simulation::Simulation(std::shared_ptr<const System> system, int threads)
    : m_system(std::move(system))
    , m_layout(layoutOf(*m_system))
    , m_state(m_system->start)
    , m_stepper(threads)
{}

void Simulation::load(std::shared_ptr<const System> system)
{
    m_atStart = system->run != m_system->run;
    if (m_atStart) {
        m_state = system->start;
        m_commands.clear();
    } else {
        m_lastGood = carryOver(*m_system, m_state, *system, std::move(m_lastGood));
        std::swap(m_state, m_lastGood);
    }
    m_system = std::move(system);
    m_layoutIsStale = true;
    m_trouble.reset(); // the edit may have cured it
}

void Simulation::load(const Update& update)
{
    if (update.system)
        load(update.system);
    if (update.patch)
        apply(*update.patch);
}

void Simulation::apply(const Patch& patch)
{
    const bool again = patch.run != m_system->run;
    System& system = ownSystem();
    m_layoutIsStale |= ripstop::apply(patch, system);
    m_trouble.reset();
    if (again)
        return reset(patch);

    // what carryOver() does, for what can differ
    for (const auto& [i, values] : patch.particles) {
        m_atStart = false;
        if (values.inverseMass == 0.0) {
            m_state.velocity[std::size_t(i)].setZero();
            m_state.drift[std::size_t(i)].setZero();
        }
    }
}

// A new run begins with the patch. While a design at rest is edited there is little to put back.
void Simulation::reset(const Patch& patch)
{
    const State& start = m_system->start;
    m_commands.clear();
    if (!std::exchange(m_atStart, true)) {
        m_state = start;
        return;
    }
    m_state.gusts = start.gusts;
    for (const auto& particle : patch.particles) {
        const auto i = std::size_t(particle.first);
        m_state.position[i] = start.position[i];
        m_state.velocity[i] = start.velocity[i];
    }
}

System& Simulation::ownSystem()
{
    // Whoever compiled it gave it away, and it was not made const.
    if (m_system.use_count() > 1)
        m_system = std::make_shared<System>(*m_system);
    return const_cast<System&>(*m_system);
}

// Views build what they draw from the layout; most edits change numbers and leave it as it is.
void Simulation::refreshLayout() const
{
    if (!std::exchange(m_layoutIsStale, false))
        return;
    if (auto layout = layoutOf(*m_system); *layout != *m_layout)
        m_layout = std::move(layout);
}

void Simulation::command(const Commands& commands)
{
    for (std::size_t i = 0; i < m_system->inputs.size(); ++i)
        if (const auto found = commands.find(m_system->inputs[i].key);
            found != commands.end() && std::isfinite(found->second)) {
            const Input& input = m_system->inputs[i];
            const double value = std::clamp(found->second, -input.limit, input.limit);
            if (value == m_state.inputCommand[i])
                continue;
            m_atStart = false;
            m_state.inputCommand[i] = value;
            m_commands.push_back({m_state.time, input.key, value});
        }
}

bool Simulation::step()
{
    if (m_trouble)
        return false;
    m_atStart = false;
    m_lastGood = m_state;
    const int substeps = m_stepper.step(*m_system, m_state);
    m_trouble = findTrouble(*m_system, m_lastGood, m_state, substeps);
    if (m_trouble)
        std::swap(m_state, m_lastGood);
    return !m_trouble;
}

bool Simulation::runUntil(double time)
{
    while (!hasReached(m_state.time, time, m_system->timeStep))
        if (!step())
            return false;
    return true;
}

std::shared_ptr<Frame> Simulation::frame() const
{
    refreshLayout();
    auto frame = std::make_shared<Frame>();
    frame->generation = m_system->generation;
    frame->run = m_system->run;
    frame->layout = m_layout;
    frame->time = m_state.time;
    frame->step = m_state.step;
    frame->solverChoice = m_stepper.choice(*m_system);
    frame->substeps = m_stepper.substepsOf(*m_system, m_state);
    frame->hash = stateHash(m_state);
    frame->position.assign(m_state.position.begin(), m_state.position.end());
    frame->velocity.assign(m_state.velocity.begin(), m_state.velocity.end());
    frame->torn.reserve(m_system->links.size());
    for (const LinkPlace& link : m_system->links)
        frame->torn.push_back(isTorn(link, m_state));
    frame->gone = m_state.panelGone;
    frame->gust = commonWind(*m_system, m_state) - m_system->wind;
    for (std::size_t i = 0; i < m_system->obstacles.size(); ++i)
        frame->colliderPosition.push_back(obstaclePosition(*m_system, m_state, i, m_state.time));
    frame->inputCommand = m_state.inputCommand;
    frame->inputValue = m_state.inputValue;

    Readings readings(*m_system, m_state);
    frame->strain = readings.strain();
    frame->tension = readings.tension();
    frame->panelLoad = readings.panelLoad();
    for (const ProbeSpec& probe : m_system->probes)
        frame->probe.push_back(readings.value(probe));

    for (const State::Tear& tear : m_state.tears)
        frame->tears.push_back(
            {tear.time, tear.link, tear.length, tear.strain, tear.force, tear.place, tear.energy});
    frame->commands = m_commands;
    if (m_trouble) {
        frame->stopped = m_trouble->message;
        frame->culprit = m_trouble->particle;
    }
    return frame;
}

} // namespace ripstop
