// Three runs on two threads: the finest, which takes longest, on that of the caller, who hears of
// its progress, and the two others beside it. Then each probe is judged, at the end and at every
// step.
#include "run/certificate.h"

#include "compile/compile.h"
#include "run/recorder.h"
#include "run/simulation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <thread>

namespace ripstop {
namespace {

constexpr double safety = 1.25;       // Roache 1994, for three grids
constexpr double safetyWithout = 3.0; // of an order
constexpr double leastOrder = 0.5;    // that the limit is told by
constexpr double roundOff = 1e-13;    // of a value
constexpr double nothing = 1e-12;     // m, N, ...: what rounding leaves of what is none
constexpr int mostDigits = 15;

struct Flight
{
    std::vector<Layout::Probe> probes;
    std::vector<double> time;               // [times] s
    std::vector<std::vector<double>> value; // [probes][times]
    std::optional<Failure> failure;         // to begin
    Message stopped;                        // why it ended early
};

bool hasFailed(const Flight& flight) { return flight.failure || !flight.stopped.empty(); }

int digitsOf(double value, double error)
{
    if (!std::isfinite(error) || !std::isfinite(value))
        return 0;
    if (error <= roundOff * std::abs(value))
        return mostDigits;
    if (value == 0.0)
        return 0;
    const double digits = std::floor(1.0 - std::log10(2.0 * error / std::abs(value)));
    return int(std::clamp(digits, 0.0, double(mostDigits)));
}

// The scene with its tolerances cut in so many.
Scene refined(Scene scene, int times)
{
    scene.settings.accuracy /= times;
    scene.settings.strainGoal /= times;
    return scene;
}

// Flies a run of which each substep is cut in so many; `goesOn` is asked at every step.
Flight fly(const Scene& scene, double seconds, int times, Pilot pilot, const Progress& goesOn,
           Recorder* recorder = nullptr)
{
    Flight flight;
    const auto system = compile(refined(scene, times));
    if (!system) {
        flight.failure = system.failure();
        return flight;
    }
    Simulation simulation(*system);
    simulation.refine(times);
    if (recorder)
        recorder->loaded(simulation, {std::make_shared<const Scene>(scene), {}});
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
        if (recorder)
            recorder->beforeStep(simulation);
        if (!simulation.step()) {
            const Message& why = simulation.trouble()->message;
            flight.stopped =
                times == 1 ? why : Message("with %1 times as many substeps: %2", times, why);
            return flight;
        }
        if (recorder)
            recorder->afterStep(simulation);
        read();
    }
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

bool grow(const std::array<double, 3>& value)
{
    const double first = std::abs(value[0] - value[1]);
    const double second = std::abs(value[1] - value[2]);
    return second > std::max(roundOff * std::abs(value[2]), nothing) && second >= first;
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

Convergence convergenceOf(const std::array<double, 3>& value)
{
    Convergence result{.value = value};
    const auto [coarse, half, fine] = value;
    const double least = std::max(roundOff * std::abs(fine), nothing);
    const double first = std::abs(coarse - half) > least ? coarse - half : 0.0;
    const double second = std::abs(half - fine) > least ? half - fine : 0.0;
    const double ratio = first / second;
    if (first == 0.0 && second == 0.0) {
        result.limit = fine;
        result.error = 0.0;
    } else if (ratio > 1.0) {
        result.order = std::log2(ratio);
        result.limit = fine - second / (std::exp2(std::max(result.order, leastOrder)) - 1.0);
        result.error = safety * std::abs(coarse - result.limit);
    } else {
        result.error = safetyWithout * std::max(std::abs(first), std::abs(second));
    }
    result.digits = digitsOf(coarse, result.error);
    return result;
}

Result<Certificate> certify(const Scene& scene, double seconds,
                            const std::function<Pilot()>& newPilot, const Progress& progress,
                            Recorder* recorder)
{
    std::array<Flight, 3> flights;
    std::atomic<bool> ends = false;
    const auto pilot = [&] { return newPilot ? newPilot() : Pilot(); };
    std::array<Pilot, 3> pilots{pilot(), pilot(), pilot()};
    std::thread beside([&] {
        const Progress goesOnBeside = [&](double) { return !ends; };
        for (const int i : {1, 0}) {
            flights[std::size_t(i)] = fly(scene, seconds, 1 << i, pilots[std::size_t(i)],
                                          goesOnBeside, i == 0 ? recorder : nullptr);
            ends = ends || hasFailed(flights[std::size_t(i)]);
        }
    });
    bool isWanted = true;
    flights[2] = fly(scene, seconds, 4, pilots[2], [&](double share) {
        isWanted = goesOn(progress, share);
        return isWanted && !ends;
    });
    ends = ends || !isWanted || hasFailed(flights[2]);
    beside.join();
    if (!isWanted)
        return Failure("Cancelled.");
    Certificate certificate{seconds, flights[0].time, {}, {}};
    for (const Flight& flight : flights) {
        if (flight.failure)
            return *flight.failure;
        if (certificate.stopped.empty())
            certificate.stopped = flight.stopped;
    }
    for (std::size_t i = 0; certificate.stopped.empty() && i < flights[0].probes.size(); ++i)
        certificate.probes.push_back(judged(flights, i));
    if (recorder && recorder->recording() && certificate.stopped.empty())
        recorder->recording()->setCertificate(std::make_shared<const Certificate>(certificate));
    return certificate;
}

double Certificate::errorAt(const std::string& probe, double at) const
{
    const auto found = std::ranges::find(probes, probe, &CertifiedProbe::name);
    // times are sums of steps, and the same in each run
    const auto moment = std::ranges::lower_bound(time, at);
    if (found == probes.end() || moment == time.end() || *moment != at)
        return Convergence::none;
    return found->error[std::size_t(moment - time.begin())];
}

} // namespace ripstop
