// When a train of discrete gusts blows: which of its gusts, for how long already, and how strong it
// is. The engine blows by it (forces/discrete_gust.h), and what tears is told by it
// (derived/gust_now.h).
#pragma once

#include <cmath>
#include <optional>

namespace ripstop {

struct GustMoment
{
    double before;   // gusts of the train that have been
    double since;    // s, from the beginning of this one
    double strength; // 1, of its peak in that of the first
};

// Of what has `onset`, `duration` and `interval`, s, and `growth`, 1; none between two gusts, and
// at other times than theirs. Both ends of a gust belong to it.
template <typename Train>
std::optional<GustMoment> gustAt(const Train& train, double time)
{
    double since = time - train.onset;
    if (!(since >= 0.0))
        return std::nullopt;
    double before = 0.0;
    if (train.interval > 0.0) {
        before = std::floor(since / train.interval);
        since -= before * train.interval;
    }
    if (!(since <= train.duration))
        return std::nullopt;
    return GustMoment{before, since, 1.0 + before * train.growth};
}

} // namespace ripstop
