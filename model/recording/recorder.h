// Writes down what a simulation does, from the thread that runs it.
//
// A recording begins with the first step of a run; what was told before is in its first state.
// All of it is called on that one thread; the recording itself may be read from any.
#pragma once

#include "recording/event_watch.h"
#include "recording/recording.h"

namespace ripstop {

class Simulation;

class Recorder
{
public:
    explicit Recorder(std::size_t memory = std::size_t(512) << 20); // bytes
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void setMemory(std::size_t bytes); // of runs that begin from now on; 0 records none

    // Call after each update of the simulation, and once at the beginning.
    void loaded(Simulation& simulation, const Design& design);
    bool beforeStep(Simulation& simulation);      // whether a recording begins
    void afterStep(const Simulation& simulation); // after those that could be made
    void finish();                                // of the run

    // Null before the first step of a run.
    const std::shared_ptr<Recording>& recording() const { return m_recording; }

private:
    void begin(Simulation& simulation);
    bool needsStart(const Simulation& simulation) const;
    void startChunk(const Simulation& simulation);
    void noteEvents(const Simulation& simulation);

    std::size_t m_memory;
    std::shared_ptr<Recording> m_recording;
    std::vector<RunInput> m_inputs; // that the simulation has told of
    EventWatch m_watch;
    Design m_design;
    int m_number = -1; // of the design

    // of the stretch under way
    int m_startDesign = -1; // its number
    std::vector<std::uint32_t> m_pins;
    std::size_t m_splits = 0;
    std::size_t m_particles = 0;
    std::size_t m_bytes = 0;      // of its frames
    std::size_t m_startBytes = 0; // of its first state
    std::int64_t m_firstStep = 0;
    std::int64_t m_lastFrame = 0; // step
    int m_stride = 1;             // steps between frames
};

} // namespace ripstop
