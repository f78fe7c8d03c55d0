// FlownFrames steps a simulation until the asked time is reached: before each step it gives the
// controls, then tells the recorder, and every 50 steps it asks whether to go on. OwnFlight is the
// same for a simulation that belongs to the source.
//
// RecordedFrames turns the time into a step by the frames around it, because the time step of a
// recording may have changed on the way. A frame that was kept of that step is taken as it is,
// unless exact places are wanted. Otherwise computed() starts from an exact state and gives the
// recorded inputs before each step. It keeps that simulation for the next call, since times ascend.
#include "export/frame_source.h"

#include "compile/compile.h"
#include "recording/input_player.h"
#include "recording/recorder.h"
#include "simulation/simulation.h"
#include "system/moment.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// Flies a simulation of its own.
class OwnFlight final : public FrameSource
{
public:
    OwnFlight(std::shared_ptr<const System> system, ControlTrack controls)
        : m_simulation(std::move(system))
        , m_frames(m_simulation, std::move(controls))
    {}

    double begin() const override { return m_frames.begin(); }
    double end() const override { return m_frames.end(); }
    double timeStep() const override { return m_frames.timeStep(); }
    Taken take(double time, const Reached& reached) override
    {
        return m_frames.take(time, reached);
    }

private:
    Simulation m_simulation;
    FlownFrames m_frames;
};

} // namespace

struct RecordedFrames::Walk
{
    Simulation simulation;
    InputPlayer inputs;
};

Message inSeconds(double time) { return Message("%1 s", Message::number("%.6g", time)); }

namespace {

Message stopped(const Simulation& simulation)
{
    return Message("The simulation stopped: %1", simulation.trouble()->message);
}

} // namespace

FlownFrames::FlownFrames(Simulation& simulation, ControlTrack controls, Recorder* recorder)
    : m_simulation(simulation)
    , m_controls(std::move(controls))
    , m_recorder(recorder)
{}

double FlownFrames::begin() const { return m_simulation.state().time; }

double FlownFrames::timeStep() const { return m_simulation.system().timeStep; }

// Steps like Simulation::runUntil().
FrameSource::Taken FlownFrames::take(double time, const Reached& reached)
{
    while (!hasReached(m_simulation.state().time, time, timeStep())) {
        if (!reached(m_simulation.state().time)) // at each, as those of a large design take long
            return {};
        m_controls.giveTo(m_simulation);
        if (m_recorder)
            m_recorder->beforeStep(m_simulation);
        if (!m_simulation.step())
            return {m_simulation.frame(), stopped(m_simulation)};
        if (m_recorder)
            m_recorder->afterStep(m_simulation);
    }
    return {m_simulation.frame(), {}};
}

Result<std::unique_ptr<FrameSource>> flightOf(const Scene& scene, ControlTrack controls)
{
    auto system = compile(scene);
    if (!system)
        return system.failure();
    return std::unique_ptr<FrameSource>(
        std::make_unique<OwnFlight>(std::move(*system), std::move(controls)));
}

RecordedFrames::RecordedFrames(std::shared_ptr<const Recording> recording, Places places,
                               int threads)
    : m_recording(std::move(recording))
    , m_places(places)
    , m_threads(threads)
    , m_timeStep(m_recording->scene().settings.timeStep)
{}

RecordedFrames::~RecordedFrames() = default;

double RecordedFrames::begin() const { return m_recording->timeOf(0); }

// The last frame need not be of the last step.
double RecordedFrames::end() const
{
    const std::size_t last = m_recording->frameCount() - 1;
    return m_recording->timeOf(last)
           + double(m_recording->lastStep() - m_recording->stepOf(last)) * timeStepFrom(last);
}

double RecordedFrames::timeStepFrom(std::size_t frame) const
{
    const std::size_t last = m_recording->frameCount() - 1;
    const std::size_t a = frame < last ? frame : last - std::min<std::size_t>(last, 1);
    const std::size_t b = std::min(a + 1, last);
    const auto steps = double(m_recording->stepOf(b) - m_recording->stepOf(a));
    return steps > 0.0 ? (m_recording->timeOf(b) - m_recording->timeOf(a)) / steps : m_timeStep;
}

// The first step that hasReached() the time.
std::int64_t RecordedFrames::stepAt(double time) const
{
    std::size_t before = m_recording->frameAt(time);
    if (before > 0 && m_recording->timeOf(before) > time)
        --before;
    const double steps =
        std::ceil((time - m_recording->timeOf(before)) / timeStepFrom(before) - 0.5 - 1e-6);
    const double step = double(m_recording->stepOf(before)) + steps;
    return std::int64_t(
        std::clamp(step, double(m_recording->firstStep()), double(m_recording->lastStep())));
}

FrameSource::Taken RecordedFrames::take(double time, const Reached& reached)
{
    const std::int64_t step = stepAt(time);
    const std::size_t kept = m_recording->frameOfStep(step);
    Taken taken;
    if (m_places == Places::Exact || m_recording->stepOf(kept) != step) {
        taken = computed(step, reached);
    } else if (auto frame = m_recording->frame(kept)) {
        taken.frame = std::move(*frame);
        if (!reached(taken.frame->time))
            return {};
    } else {
        taken.end = frame.message();
    }
    if (taken.end.empty() && time > end() + 0.5 * m_timeStep)
        taken.end = Message("The recording ends at %1.", inSeconds(end()));
    return taken;
}

FrameSource::Taken RecordedFrames::computed(std::int64_t step, const Reached& reached)
{
    if (!m_walk || m_walk->simulation.state().step > step) {
        bool cancelled = false;
        const double time = begin();
        auto moment = m_recording->moment(
            step, [&](double) { return !(cancelled = cancelled || !reached(time)); });
        if (!moment)
            return {nullptr, cancelled ? Message() : moment.message()};
        Moment& from = **moment;
        InputPlayer inputs(*m_recording, from.state);
        m_walk = std::make_unique<Walk>(
            Walk{Simulation(from.system, std::move(from.state), m_threads), std::move(inputs)});
    }
    auto& [simulation, inputs] = *m_walk;
    while (simulation.state().step < step) {
        if (!reached(simulation.state().time))
            return {};
        if (auto failure = inputs.giveTo(simulation))
            return {simulation.frame(), failure->message};
        if (!simulation.step())
            return {simulation.frame(), stopped(simulation)};
    }
    return {simulation.frame(), {}};
}

} // namespace ripstop
