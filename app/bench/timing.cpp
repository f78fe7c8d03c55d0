// stepsInBlock() finds how many steps take about 3 ms; timeInRounds() then runs one block of each
// runner in turn, round after round, so that a disturbance of the machine hits neighbours alike.
// The runners at the end put their setup into the shared system before each block and begin each
// block from the same state, so that all blocks do the same work.
#include "bench/timing.h"

#include "step/stepper.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ripstop {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double blockSeconds = 0.003;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double percentile(const std::vector<double>& sorted, double share)
{
    return sorted[std::size_t(std::lround(share * double(sorted.size() - 1)))];
}

double timeBlock(BenchRunner& runner, int steps)
{
    if (runner.reset)
        runner.reset();
    const auto start = Clock::now();
    for (int i = 0; i < steps; ++i)
        runner.step();
    return secondsSince(start) / steps;
}

int stepsInBlock(BenchRunner& runner)
{
    const double first = timeBlock(runner, 1); // fills caches
    if (first > blockSeconds)
        return 1;
    const double second = timeBlock(runner, int(std::clamp(0.3 * blockSeconds / first, 1.0, 1e6)));
    return int(std::clamp(std::ceil(blockSeconds / second), 1.0, 1e6));
}

struct Engine
{
    std::shared_ptr<System> system;
    Setup setup;
    Stepper stepper;
    State begin;
    State state;
};

std::shared_ptr<Engine> engineOf(const BenchNetwork& network, const Setup& setup)
{
    return std::make_shared<Engine>(
        Engine{network.system, setup, Stepper(setup.threads), network.system->start, {}});
}

} // namespace

TimingSummary timingSummaryOf(std::vector<double> values)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    return {percentile(values, 0.1), percentile(values, 0.5), percentile(values, 0.9),
            int(values.size())};
}

TimingSummary scaled(TimingSummary times, double factor)
{
    return {times.quiet * factor, times.median * factor, times.slow * factor, times.blocks};
}

TimingSummary rates(const TimingSummary& times)
{
    return {1.0 / times.quiet, 1.0 / times.median, 1.0 / times.slow, times.blocks};
}

std::vector<std::vector<double>> timeInRounds(const std::string& label,
                                              std::vector<BenchRunner>& runners, double budget,
                                              int leastRounds)
{
    ProgressLine progress("timing " + label);
    std::vector<int> steps;
    for (BenchRunner& runner : runners)
        steps.push_back(interrupted() ? 1 : stepsInBlock(runner));
    std::vector<std::vector<double>> times(runners.size());
    const auto start = Clock::now();
    for (int round = 0; round < leastRounds || secondsSince(start) < budget; ++round)
        for (std::size_t i = 0; i < runners.size(); ++i) {
            if (interrupted())
                return std::vector<std::vector<double>>(runners.size());
            times[i].push_back(timeBlock(runners[i], steps[i]));
            progress.show(std::min(secondsSince(start) / budget, 1.0));
        }
    return times;
}

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b)
{
    std::vector<double> quotients;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        quotients.push_back(a[i] / b[i]);
    return quotients;
}

void apply(const Setup& setup, System& system)
{
    system.solver = setup.solver;
    system.substeps = setup.substeps;
    system.sweeps = setup.sweeps;
    system.strainGoal = setup.strainGoal;
}

BenchRunner restartingRunner(const BenchNetwork& network, const Setup& setup, int steps)
{
    const auto engine = engineOf(network, setup);
    return {[engine] {
                apply(engine->setup, *engine->system);
                engine->state = engine->begin;
            },
            [engine, steps] {
                if (engine->state.step - engine->begin.step >= steps)
                    engine->state = engine->begin;
                engine->stepper.step(*engine->system, engine->state);
            }};
}

BenchRunner engineRunner(const BenchNetwork& network, const Setup& setup)
{
    const auto engine = engineOf(network, setup);
    apply(setup, *network.system);
    const auto start = Clock::now();
    const bool automatic = setup.solver == Solver::Auto;
    const int steps = automatic ? 200 : 50;
    const double most = automatic ? 5.0 : 0.1; // s
    for (int i = 0; i < steps && secondsSince(start) < most; ++i)
        engine->stepper.step(*engine->system, engine->begin);
    return {[engine] {
                apply(engine->setup, *engine->system);
                engine->state = engine->begin;
            },
            [engine] { engine->stepper.step(*engine->system, engine->state); }};
}

} // namespace ripstop
