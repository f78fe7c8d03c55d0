// Three runs on two threads: the finest, which takes longest, on that of the caller, who hears of
// its progress, and the two others beside it. Then each probe is judged, at the end and at every
// step.
#include "run/certify.h"

#include "compile/compile.h"
#include "recording/recorder.h"
#include "simulation/simulation.h"

#include <atomic>
#include <cmath>
#include <optional>
#include <thread>

namespace ripstop {
namespace {

struct Flight
{
    std::vector<Layout::Probe> probes;
    std::vector<double> time;               // [times] s
    std::vector<std::vector<double>> value; // [probes][times]
    std::shared_ptr<Recording> recording;   // of the run as it is, once it is over
    std::optional<Failure> failure;         // to begin
    Message stopped;                        // why it ended early
};

bool hasFailed(const Flight& flight) { return flight.failure || !flight.stopped.empty(); }

// The scene with its tolerances cut in so many.
Scene refined(Scene scene, int times)
{
    scene.settings.accuracy /= times;
    scene.settings.strainGoal /= times;
    return scene;
}

// Flies a run of which each substep is cut in so many; `goesOn` is asked at every step.
Flight fly(const Scene& scene, double seconds, int times, int threads, Pilot pilot,
           const Progress& goesOn)
{
    Flight flight;
    const auto system = compile(refined(scene, times));
    if (!system) {
        flight.failure = system.failure();
        return flight;
    }
    Simulation simulation(*system, threads);
    simulation.refine(times);
    Recorder recorder;
    if (times == 1) // otherwise it has no design, and records nothing
        recorder.loaded(simulation, {std::make_shared<const Scene>(scene), {}});
    flight.probes = simulation.sample().layout->probes;
    flight.value.resize(flight.probes.size());
    if (flight.probes.empty()) {
        flight.failure = Failure("the scene has no probe that could be judged: add one");
        return flight;
    }
    const auto read = [&] {
        const ProbeSample sample = simulation.sample();
        flight.time.push_back(sample.time);
        for (std::size_t i = 0; i < flight.value.size(); ++i)
            flight.value[i].push_back(sample.probe[i]);
    };
    read();
    while (!hasReached(simulation.state().time, seconds, (*system)->timeStep)) {
        if (!goesOn(simulation.state().time / seconds))
            return flight;
        if (pilot)
            pilot(simulation);
        recorder.beforeStep(simulation);
        if (!simulation.step()) {
            const Message& why = simulation.trouble()->message;
            flight.stopped =
                times == 1 ? why : Message("with %1 times as many substeps: %2", times, why);
            return flight;
        }
        recorder.afterStep(simulation);
        read();
    }
    flight.recording = recorder.recording();
    recorder.finish();
    return flight;
}

// Over the second half, moments without a reading left out.
double meanOf(const std::vector<double>& values)
{
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = values.size() / 2; i < values.size(); ++i)
        if (std::isfinite(values[i])) {
            sum += values[i];
            ++count;
        }
    return count > 0 ? sum / count : Convergence::none;
}

// What is at rest differs by what solvers leave, which need not shrink.
bool grow(const std::array<double, 3>& value)
{
    constexpr double leftBySolvers = 1e-9; // of a value
    const double first = std::abs(value[0] - value[1]);
    const double second = std::abs(value[1] - value[2]);
    return second > std::max(roundingOf(value[2]), leftBySolvers * std::abs(value[2]))
           && second >= first;
}

CertifiedProbe judged(const std::array<Flight, 3>& flights, std::size_t i)
{
    const Layout::Probe& probe = flights[0].probes[i];
    CertifiedProbe certified{probe.name, probe.unit, false, {}, flights[0].value[i], {}};
    const auto valuesBy = [&](auto read) {
        return std::array{read(flights[0].value[i]), read(flights[1].value[i]),
                          read(flights[2].value[i])};
    };
    const auto last = valuesBy([](const std::vector<double>& values) { return values.back(); });
    certified.ofMean = grow(last);
    certified.result = convergenceOf(certified.ofMean ? valuesBy(meanOf) : last);
    for (std::size_t k = 0; k < certified.value.size(); ++k)
        certified.error.push_back(convergenceOf(valuesBy([k](const std::vector<double>& values) {
                                      return values[k];
                                  })).error);
    return certified;
}

} // namespace

Result<Certification> certify(const Scene& scene, double seconds,
                              const std::function<Pilot()>& newPilot, const Progress& progress,
                              int threads)
{
    if (!(seconds >= scene.settings.timeStep))
        return Failure("nothing is certified in less than a time step, %1 s; certify a longer time",
                       Message::number("%.3g", scene.settings.timeStep));
    std::array<Flight, 3> flights;
    std::atomic<bool> ends = false;
    const auto pilot = [&] { return newPilot ? newPilot() : Pilot(); };
    std::array<Pilot, 3> pilots{pilot(), pilot(), pilot()};
    std::thread beside([&] {
        const Progress goesOnBeside = [&](double) { return !ends; };
        for (const int i : {1, 0}) {
            flights[std::size_t(i)] =
                fly(scene, seconds, 1 << i, threads, pilots[std::size_t(i)], goesOnBeside);
            ends = ends || hasFailed(flights[std::size_t(i)]);
        }
    });
    bool isWanted = true;
    flights[2] = fly(scene, seconds, 4, threads, pilots[2], [&](double share) {
        isWanted = goesOn(progress, share);
        return isWanted && !ends;
    });
    ends = ends || !isWanted || hasFailed(flights[2]);
    beside.join();
    if (!isWanted)
        return Failure("Cancelled.");
    Certification made{{seconds, flights[0].time, {}}, flights[0].recording, {}};
    for (const Flight& flight : flights) {
        if (flight.failure)
            return *flight.failure;
        if (made.stopped.empty())
            made.stopped = flight.stopped;
    }
    for (std::size_t i = 0; made.stopped.empty() && i < flights[0].probes.size(); ++i)
        made.certificate.probes.push_back(judged(flights, i));
    if (made.flown && made.stopped.empty())
        made.flown->setCertificate(std::make_shared<const Certificate>(made.certificate));
    return made;
}

} // namespace ripstop
