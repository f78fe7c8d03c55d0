// fly() makes steps and lets the measures read after each; Readers finds their probes once.
#include "study/flight.h"

#include "base/hash_text.h"
#include "compile/compile.h"
#include "measure/diagnostics.h"
#include "recording/recorder.h"
#include "run/end_check.h"
#include "run/tear_report.h"
#include "simulation/simulation.h"
#include "study/probe_names.h"

#include <algorithm>

namespace ripstop {
namespace {

// What the measures read, by the places of their probes in the layout.
class Readers
{
public:
    //   probes  with distinct names
    Readers(const std::vector<Measure>& measures, const std::vector<Layout::Probe>& probes)
    {
        for (const Measure& measure : measures) {
            const auto found = std::ranges::find(probes, measure.probe, &Layout::Probe::name);
            m_place.push_back(std::size_t(found - probes.begin()));
            m_reader.emplace_back(measure);
        }
    }

    void take(const Simulation& simulation, double timeStep)
    {
        if (m_reader.empty())
            return;
        const ProbeSample sample = simulation.sample();
        for (std::size_t i = 0; i < m_reader.size(); ++i)
            if (m_place[i] < sample.probe.size())
                m_reader[i].take(sample.time, sample.probe[m_place[i]], sample.most()[m_place[i]],
                                 timeStep);
    }

    std::vector<double> results() const
    {
        std::vector<double> all;
        for (const MeasureReader& reader : m_reader)
            all.push_back(reader.result());
        return all;
    }

private:
    std::vector<std::size_t> m_place;
    std::vector<MeasureReader> m_reader;
};

std::vector<Layout::Probe> namedProbes(const Simulation& simulation)
{
    std::vector<Layout::Probe> probes = simulation.sample().layout->probes;
    const std::vector<std::string> names = distinctNames(probes);
    for (std::size_t i = 0; i < names.size(); ++i)
        probes[i].name = names[i];
    return probes;
}

} // namespace

void ProbeCurves::take(const ProbeSample& sample)
{
    time.push_back(sample.time);
    value.resize(sample.probe.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        value[i].resize(time.size() - 1, std::numeric_limits<double>::quiet_NaN());
        value[i].push_back(sample.probe[i]);
    }
}

std::optional<FlightResult> fly(const Scene& scene, const ControlTrack& controls,
                                const FlightPlan& plan, Recorder* recorder, ProbeCurves* curves)
{
    FlightResult flight;
    flight.measured.assign(plan.measures.size(), std::numeric_limits<double>::quiet_NaN());
    const auto system = compile(scene);
    if (!system) {
        flight.stopped = system.message().english();
        return flight;
    }
    Simulation simulation(*system, plan.threads);
    ControlPlayer player(controls);
    const double timeStep = (*system)->timeStep;
    flight.probes = namedProbes(simulation);
    Readers readers(plan.measures.empty() ? usualMeasures(flight.probes, plan.from) : plan.measures,
                    flight.probes);
    const auto read = [&] {
        readers.take(simulation, timeStep);
        if (curves)
            curves->take(simulation.sample());
    };
    StudyProgress::Flight underWay(plan.progress, plan.seconds);
    read();
    if (recorder)
        recorder->loaded(simulation, {std::make_shared<const Scene>(scene), {}});
    while (!hasReached(simulation.state().time, plan.seconds, timeStep)) {
        if (plan.isInterrupted())
            return std::nullopt;
        player.giveTo(simulation);
        if (recorder)
            recorder->beforeStep(simulation);
        const bool couldStep = simulation.step();
        if (recorder)
            recorder->afterStep(simulation);
        if (!couldStep) {
            flight.stopped = simulation.trouble()->message.english();
            break;
        }
        read();
        underWay.reached(simulation.state().time);
        if (plan.untilTear && !simulation.state().tears.empty())
            break;
    }
    flight.time = simulation.state().time;
    flight.steps = simulation.state().step;
    flight.hash = hashText(stateHash(simulation.state()));
    const auto frame = simulation.frame();
    flight.torn = tornElements(*frame);
    if (!frame->tears.empty()) {
        flight.firstTear = frame->tears.front().time;
        flight.firstTearLoad = frame->tears.front().force;
        flight.firstTearUnit = loadUnit(frame->tears.front(), *frame->layout);
        flight.firstTorn = frame->tears.front().element;
    }
    if (flight.stopped.empty())
        for (const Message& one : absurdities(simulation))
            flight.absurd += (flight.absurd.empty() ? "" : " ") + one.english();
    flight.inaccurate = frame->accuracy.complaint().english();
    flight.measured = readers.results();
    return flight;
}

FlightOutcome outcomeOf(const FlightResult* flight)
{
    if (!flight)
        return FlightOutcome::Missing;
    if (flight->endedEarly())
        return FlightOutcome::Stopped;
    return flight->torn > 0 ? FlightOutcome::Torn : FlightOutcome::Held;
}

Result<std::vector<Layout::Probe>> probesOf(const Scene& scene)
{
    const auto system = compile(scene);
    if (!system)
        return system.failure();
    return namedProbes(Simulation(*system));
}

} // namespace ripstop
