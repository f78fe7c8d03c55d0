// A replay starts from the first exact state, gives each step the inputs that were recorded and
// compares hashes. After the first hash that differs it goes on to the next frame in which a
// particle differs by more than a frame's precision, to say where.
#include "recording/replay.h"

#include "measure/diagnostics.h"
#include "recording/input_player.h"
#include "recording/recording.h"
#include "simulation/simulation.h"
#include "system/moment.h"

#include <algorithm>

namespace ripstop {
namespace {

// A frame keeps the way since the last exact state in single precision; a second is the longest,
// and a margin stands for what the speed does in it.
double roundOffOf(const Vec3& velocity) { return 1e-6 * velocity.norm() + 1e-8; } // m

std::optional<ReplayDifference::Seen> firstApart(const Frame& kept, const State& state)
{
    for (std::size_t i = 0; i < kept.position.size() && i < state.position.size(); ++i) {
        const double distance = (kept.position[i] - state.position[i]).norm();
        if (!(distance <= roundOffOf(kept.velocity[i])))
            return ReplayDifference::Seen{kept.layout->particleId[i], kept.step, distance};
    }
    return std::nullopt;
}

class Comparison
{
public:
    Comparison(const Recording& recording, ReplayOutcome& outcome)
        : m_recording(recording)
        , m_outcome(outcome)
    {}

    // Whether there is more to find out.
    bool look(const State& state)
    {
        const std::uint64_t hash = stateHash(state);
        const std::uint64_t recorded = m_recording.hashOf(state.step);
        m_outcome.hash = hash;
        if (!m_outcome.difference && hash != recorded)
            m_outcome.difference = {state.step, state.time, recorded, hash, std::nullopt};
        if (!m_outcome.difference)
            return true;
        const std::size_t frame = m_recording.frameOfStep(state.step);
        if (m_recording.stepOf(frame) != state.step)
            return true;
        const auto kept = m_recording.frame(frame);
        if (!kept)
            return false;
        m_outcome.difference->seen = firstApart(**kept, state);
        return !m_outcome.difference->seen;
    }

private:
    const Recording& m_recording;
    ReplayOutcome& m_outcome;
};

} // namespace

Result<ReplayOutcome> replay(const Recording& recording, int threads, const Progress& progress)
{
    auto start = recording.moment(recording.firstStep());
    if (!start)
        return start.failure();
    Moment& from = **start;
    InputPlayer inputs(recording, from.state);
    Simulation simulation(from.system, std::move(from.state), threads);
    return compareFlight(
        recording, simulation, [&](Simulation& flown) { return inputs.giveTo(flown); }, progress);
}

Result<ReplayOutcome> compareFlight(const Recording& recording, Simulation& simulation,
                                    const BeforeStep& tell, const Progress& progress)
{
    ReplayOutcome outcome;
    Comparison comparison(recording, outcome);
    const std::int64_t first = recording.firstStep();
    const std::int64_t last = recording.lastStep();
    bool goes = comparison.look(simulation.state());
    while (goes && simulation.state().step < last) {
        if (auto failure = tell(simulation))
            return *failure;
        if (!simulation.step())
            return Failure("The run cannot be computed to its end here: %1",
                           simulation.trouble()->message);
        ++outcome.steps;
        goes = comparison.look(simulation.state());
        const double share = double(simulation.state().step - first)
                             / double(std::max<std::int64_t>(1, last - first));
        if (!goesOn(progress, share)) {
            outcome.cancelled = true;
            break;
        }
    }
    return outcome;
}

} // namespace ripstop
