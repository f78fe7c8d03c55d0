// One flight of a study or a sweep: a scene from its start to its end, and what was measured.
#pragma once

#include "io/control_track.h"
#include "scene/scene.h"
#include "study/measure.h"
#include "study/study_progress.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

class Recorder; // recording/recorder.h

struct FlightPlan
{
    double seconds = 0.0; // s
    bool untilTear = false;
    std::vector<Measure> measures; // empty: the usual ones of each probe (usualMeasures())
    double from = 0.0;             // s, of the usual ones
    int threads = 1;
    std::function<bool()> isInterrupted = [] { return false; }; // asked between steps
    StudyProgress* progress = nullptr; // hears after each step how far the flight is; may be null
};

struct FlightResult
{
    double time = 0.0; // s, at the end
    std::int64_t steps = 0;
    std::string hash; // of the last state
    std::size_t torn = 0;
    double firstTear = std::numeric_limits<double>::quiet_NaN(); // s
    double firstTearLoad = std::numeric_limits<double>::quiet_NaN();
    std::string firstTearUnit;    // of the load: loadUnit(); empty in ledgers that did not keep it
    std::uint32_t firstTorn = 0;  // id of the element
    std::string stopped;          // why it ended early, or cannot begin; empty when it did not
    std::string absurd;           // what its end cannot be; empty when it can
    std::string inaccurate;       // that it missed the wanted accuracy; empty when it did not
    std::vector<double> measured; // [measures] not a number where nothing counted
    std::vector<Layout::Probe> probes; // with names that tell them apart

    bool endedEarly() const { return !whyEarly().empty(); } // or in what cannot be
    const std::string& whyEarly() const { return stopped.empty() ? absurd : stopped; }
};

// What all probes read at each step.
struct ProbeCurves
{
    std::vector<double> time;               // [samples] s
    std::vector<std::vector<double>> value; // [probes][samples] in the unit of the probe

    void take(const ProbeSample& sample);
};

enum class FlightOutcome { Missing, Held, Torn, Stopped };
FlightOutcome outcomeOf(const FlightResult* flight); // of one that is not flown: Missing

// Flies it. What cannot be compiled or diverges is a flight that says so; nothing comes back when
// it was interrupted. A recorder keeps the flight, frame by frame; who
// has it takes the recording and finishes it.
std::optional<FlightResult> fly(const Scene& scene, const ControlTrack& controls,
                                const FlightPlan& plan, Recorder* recorder = nullptr,
                                ProbeCurves* curves = nullptr);

// The probes of a scene, with names that tell them apart, and their units.
Result<std::vector<Layout::Probe>> probesOf(const Scene& scene);

} // namespace ripstop
