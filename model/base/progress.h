// How long work says how far it has come, and how it is told to stop.
//
// Files, exports, replays and repairs of meshes take a Progress and call it now and then, on the
// thread that does the work. An empty one means that nobody asks; goesOn() is then always true.
#pragma once

#include <functional>

namespace ripstop {

// Called with the share of the work that is done, 0 to 1; the work stops when it returns false.
using Progress = std::function<bool(double)>;

inline bool goesOn(const Progress& progress, double share) { return !progress || progress(share); }

// The progress of one stage, which takes the work from `from` to `to`. It refers to `progress`,
// which must live as long.
inline Progress stageOf(const Progress& progress, double from, double to)
{
    if (!progress)
        return {};
    return [&progress, from, to](double share) { return progress(from + share * (to - from)); };
}

} // namespace ripstop
