// What probes would have read in a run that went without them.
//
// They are read again from what is kept at the frames of its recording: places, velocities, pulls,
// works and what is torn. A probe that asks for more, such as an acceleration, which needs the step
// before, or for things that the design did not have yet, has no past.
#pragma once

#include "base/progress.h"
#include "recording/recording.h"
#include "scene/scene.h"

#include <vector>

namespace ripstop {

struct ProbePast
{
    std::vector<double> time;               // [frames] s
    std::vector<std::vector<double>> value; // [probes][frames]; not a number where it has none
};

// `probes` are entries of probes, which take the place of those that the run had. Ends early when
// the progress says so, with the frames until then. May be called from any thread.
ProbePast probePast(const Recording& recording, const std::vector<Entry>& probes,
                    const Progress& progress = {});

} // namespace ripstop
