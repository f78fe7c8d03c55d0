// Flights that are recorded, step by step.
#pragma once

#include "compile/compile.h"
#include "run/recorder.h"

#include <functional>
#include <memory>

namespace ripstop {

inline Design designOf(const Scene& scene) { return {std::make_shared<const Scene>(scene), {}}; }

// Tells the simulation things as the steps go by.
using Pilot = std::function<void(Simulation&, Recorder&, int step)>;

inline std::shared_ptr<Recording> flown(const Scene& scene, int steps, const Pilot& pilot = {},
                                        int threads = 1, std::size_t memory = std::size_t(64) << 20)
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
