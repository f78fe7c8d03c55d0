// A recording, computed once more from its first state and its inputs, and compared hash by hash.
// It takes as long as the run took to compute, on the thread that calls it.
#pragma once

#include "base/progress.h"
#include "base/result.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace ripstop {

class Recording;
class Simulation;

struct ReplayDifference
{
    std::int64_t step = 0; // the first whose hash differs
    double time = 0.0;     // s
    std::uint64_t recorded = 0;
    std::uint64_t computed = 0;

    // The first particle that differs by more than a recording keeps, and the step where that was
    // seen: frames are not kept of each step.
    struct Seen
    {
        std::uint32_t particle = 0; // id
        std::int64_t step = 0;
        double distance = 0.0; // m
    };
    std::optional<Seen> seen;
};

struct ReplayOutcome
{
    std::int64_t steps = 0; // that were computed
    std::uint64_t hash = 0; // after them
    std::optional<ReplayDifference> difference;
    bool cancelled = false;
};

// Fails when it cannot be computed: a design that does not compile here, a damaged first state.
Result<ReplayOutcome> replay(const Recording& recording, int threads,
                             const Progress& progress = {});

// The same for any flight: a simulation at the first step of the recording. `tell` is called before
// each step.
using BeforeStep = std::function<std::optional<Failure>(Simulation&)>;
Result<ReplayOutcome> compareFlight(const Recording& recording, Simulation& simulation,
                                    const BeforeStep& tell, const Progress& progress = {});

} // namespace ripstop
