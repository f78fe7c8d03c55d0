// A wind as somebody has measured it, the same everywhere: what it deviates by from its mean, at
// some times, straight from each to the next. Before the first and after the last it blows as
// there.
//
// The mean is a part of System::wind, so that whoever asks for the wind without its gusts has it.
#pragma once

#include "base/vec3.h"

#include <algorithm>
#include <vector>

namespace ripstop {

struct WindSample
{
    double time = 0.0;            // s
    Vec3 velocity = Vec3::Zero(); // m/s, less the mean

    friend bool operator==(const WindSample&, const WindSample&) = default;
};

struct WindRecord
{
    std::vector<WindSample> samples; // one or more, times rise

    friend bool operator==(const WindRecord&, const WindRecord&) = default;
};

// m/s, less the mean, at a time of the run, s. Pure: any thread may call it.
inline Vec3 velocityOf(const WindRecord& record, double time)
{
    const auto after = std::ranges::upper_bound(record.samples, time, {}, &WindSample::time);
    if (after == record.samples.begin())
        return record.samples.front().velocity;
    const WindSample& last = *(after - 1);
    if (after == record.samples.end())
        return last.velocity;
    const double share = (time - last.time) / (after->time - last.time);
    return last.velocity + share * (after->velocity - last.velocity);
}

} // namespace ripstop
