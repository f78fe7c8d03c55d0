// Flies a scene step by step with a recorder beside it and returns the finished recording, as the
// runner of the window makes it, but on the calling thread and with nothing left to timing.
//
// A RecordedPilot can act before each step. The scene must compile. Memory is in bytes.
#pragma once

#include "compile/compile.h"
#include "recording/recorder.h"
#include "simulation/simulation.h"

#include <functional>
#include <memory>

namespace ripstop {

inline Design designOf(const Scene& scene) { return {std::make_shared<const Scene>(scene), {}}; }

// Called before each step; it may give orders to the simulation and tell the recorder of them.
using RecordedPilot = std::function<void(Simulation&, Recorder&, int step)>;

inline std::shared_ptr<Recording> flown(const Scene& scene, int steps,
                                        const RecordedPilot& pilot = {}, int threads = 1,
                                        std::size_t memory = std::size_t(64) << 20)
{
    Simulation simulation(*compile(scene), threads);
    Recorder recorder(memory);
    recorder.loaded(simulation, designOf(scene));
    for (int step = 0; step < steps; ++step) {
        if (pilot)
            pilot(simulation, recorder, step);
        recorder.beforeStep(simulation);
        if (!simulation.step())
            break;
        recorder.afterStep(simulation);
    }
    const auto recording = recorder.recording();
    recorder.finish();
    recording->settle();
    return recording;
}

} // namespace ripstop
