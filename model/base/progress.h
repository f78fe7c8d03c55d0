#pragma once

#include <functional>

namespace ripstop {

// Called with the share of a long work that is done, 0 to 1; false cancels.
using Progress = std::function<bool(double)>;

inline bool goesOn(const Progress& progress, double share) { return !progress || progress(share); }

// The progress of one stage, which takes the work from `from` to `to`.
inline Progress stageOf(const Progress& progress, double from, double to)
{
    if (!progress)
        return {};
    return [&progress, from, to](double share) { return progress(from + share * (to - from)); };
}

} // namespace ripstop
