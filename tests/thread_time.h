// The time that the calling thread has worked, in ms. Unlike a clock on the wall it is not longer
// on a machine that is busy with something else, so that tests can bound it; bounds are multiplied
// by `slowdown`, since the thread sanitizer makes all work slower.
#pragma once

#include <ctime>

namespace ripstop {

inline double threadTime()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

// How much longer work may take in this build than in a plain one.
#ifdef __SANITIZE_THREAD__
inline constexpr double slowdown = 10.0; // 5 to 15, as the manual of the thread sanitizer says
#else
inline constexpr double slowdown = 1.0;
#endif

} // namespace ripstop
