// The recorder begins a recording at the first step and after each step notes events, hash and
// inputs. A stretch ends when its frames take more than eight times the bytes of its exact state
// and more than 256 KiB, when more than a second of simulated time has passed, or when design,
// splits, hand pins or the number of particles change, since frames are differences to its first
// state.
#include "recording/recorder.h"

#include "measure/diagnostics.h"
#include "recording/run_chunk.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

constexpr double longest = 1.0;                          // s, between exact states
constexpr std::size_t frameShare = 8;                    // of frames to a state, in bytes
constexpr std::size_t leastBytes = 1 << 18;              // of a stretch
constexpr std::size_t lightFrame = std::size_t(1) << 16; // bytes; lighter ones are all kept
constexpr double slowest = 1.0 / 60.0;                   // s, between frames of heavy scenes

int strideOf(const System& system, std::size_t frameBytes)
{
    const int most = std::max(1, int(slowest / system.timeStep + 0.5));
    const std::size_t asked = 1 + frameBytes / lightFrame;
    return int(std::min(std::size_t(most), asked));
}

} // namespace

Recorder::Recorder(std::size_t memory)
    : m_memory(memory)
{}

Recorder::~Recorder() { finish(); }

void Recorder::setMemory(std::size_t bytes) { m_memory = bytes; }

void Recorder::finish()
{
    if (!m_recording)
        return;
    m_recording->addInputs(std::exchange(m_inputs, {})); // that no step followed
    m_recording->finish();
    m_recording.reset();
}

void Recorder::loaded(Simulation& simulation, const Design& design)
{
    const bool again = m_recording && m_recording->run() != simulation.system().run;
    if (again)
        finish();
    simulation.keepInputs(&m_inputs);
    if (!design.base)
        return;
    m_design = design;
    m_number = -1;
    if (!m_recording)
        return;
    m_number = m_recording->addDesign(design);
    RunInput& input = m_inputs.emplace_back();
    input.step = simulation.state().step;
    input.what.emplace<DesignChange>(DesignChange{m_number});
}

void Recorder::begin(Simulation& simulation)
{
    m_inputs.clear(); // they are in the state that it begins with
    m_watch.begin(simulation);
    m_recording = std::make_shared<Recording>(m_memory, simulation.system().run);
    m_number = m_recording->addDesign(m_design);
    startChunk(simulation);
}

bool Recorder::beforeStep(Simulation& simulation)
{
    if (m_recording || m_memory == 0 || !m_design.base)
        return false;
    begin(simulation);
    return true;
}

bool Recorder::needsStart(const Simulation& simulation) const
{
    const State& state = simulation.state();
    const bool changed = m_startDesign != m_number || state.splits.size() != m_splits
                         || state.hands.pins != m_pins || state.position.size() != m_particles;
    const bool full = m_bytes > std::max(leastBytes, frameShare * m_startBytes)
                      || double(state.step - m_firstStep) * simulation.system().timeStep > longest;
    return changed || full;
}

void Recorder::startChunk(const Simulation& simulation)
{
    const State& state = simulation.state();
    m_recording->startChunk(state, m_number);
    m_startDesign = m_number;
    m_splits = state.splits.size();
    m_pins = state.hands.pins;
    m_particles = state.position.size();
    m_startBytes = bytesIn(state);
    m_firstStep = m_lastFrame = state.step;
    const std::size_t frameBytes =
        sizeof(float) * (6 * state.position.size() + state.rodTension.size());
    m_bytes = frameBytes;
    m_stride = strideOf(simulation.system(), frameBytes);
    m_recording->addStep(state.step, stateHash(state));
    m_recording->addFrame(state);
}

void Recorder::afterStep(const Simulation& simulation)
{
    if (!m_recording)
        return;
    const State& state = simulation.state();
    noteEvents(simulation);
    if (needsStart(simulation))
        return startChunk(simulation);
    m_recording->addStep(state.step, stateHash(state));
    if (state.step - m_lastFrame < m_stride)
        return;
    m_lastFrame = state.step;
    m_bytes += m_recording->addFrame(state);
}

void Recorder::noteEvents(const Simulation& simulation)
{
    for (const RunEvent& event : m_watch.look(simulation, m_inputs))
        m_recording->addEvent(event);
    if (!m_inputs.empty())
        m_recording->addInputs(std::exchange(m_inputs, {}));
}

} // namespace ripstop
