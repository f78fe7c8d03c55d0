// Two recordings, instant by instant: how far apart are the particles that both have? Recordings
// may be read from any thread, and so may this be called from any.
#pragma once

#include "recording/recording.h"

#include <vector>

namespace ripstop {

struct RunDistance
{
    double time = 0.0;          // s
    std::size_t particles = 0;  // that both have, by key
    double rms = 0.0;           // m, root of the mean square
    double most = 0.0;          // m
    std::uint32_t farthest = 0; // id of that particle
};

RunDistance distanceOf(const Frame& a, const Frame& b);

// At the frames of `a` that lie in the time of both, `interval` s apart or more. Where the other
// one has no frame of that time, its nearest is moved on by its velocities.
Result<std::vector<RunDistance>> compareRuns(const Recording& a, const Recording& b,
                                             double interval = 0.0, const Progress& progress = {});

} // namespace ripstop
