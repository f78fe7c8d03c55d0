// How speed is measured on a machine that is never quite quiet.
//
// What is compared runs in turn, a block of about 3 ms each, round after round: a disturbance hits
// neighbours alike, and a ratio is formed inside one round. Of the blocks the 10th percentile is
// called quiet, what the machine gives when left alone; the median and the 90th percentile say how
// much it was not.
#pragma once

#include "bench/networks.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ripstop {

struct TimingSummary
{
    double quiet = 0.0; // 10th percentile of times and ratios, 90th of rates
    double median = 0.0;
    double slow = 0.0; // 90th percentile of times and ratios, 10th of rates
    int blocks = 0;
};

TimingSummary timingSummaryOf(std::vector<double> values);

TimingSummary scaled(TimingSummary times,
                     double factor);             // in another unit: all three times the factor
TimingSummary rates(const TimingSummary& times); // 1 / time

// One thing that is timed.
struct BenchRunner
{
    std::function<void()> reset; // before each block, not timed; may be empty
    std::function<void()> step;
};

// s for one step, [runners][rounds]. Rounds go on until the budget, s of wall time for all runners
// together, is used up; there are at least `leastRounds`. Empty lists when interrupted. The label
// is shown with the progress.
std::vector<std::vector<double>> timeInRounds(const std::string& label,
                                              std::vector<BenchRunner>& runners, double budget,
                                              int leastRounds = 5);

// Quotients a / b of the same rounds.
std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b);

// How the engine is asked to solve.
struct Setup
{
    Solver solver = Solver::GaussSeidel;
    int substeps = 1;
    int sweeps = 1;
    int threads = 1;
    double strainGoal = 0.01; // 1, of Solver::Auto
};

void apply(const Setup& setup, System& system);

// Steps the network from a state some steps into its motion, the same one for each block; the
// automatic solver has found its substeps by then. The network's system is shared: the setup is put
// into it before each block.
BenchRunner engineRunner(const BenchNetwork& network, const Setup& setup);

// The first steps of the motion over and over, for setups that cannot hold a design for long. What
// going back costs, a copy of the state every `steps` steps, is timed too.
BenchRunner restartingRunner(const BenchNetwork& network, const Setup& setup, int steps);

} // namespace ripstop
