#include "io/recording_bounds.h"

#include "recording/packed.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::int64_t mostSteps = std::int64_t(1) << 53; // that a double can count

// Times are sums of time steps; what rounding and later versions may make of that is far less.
constexpr double loosely = 2.0;

} // namespace

bool RecordingBudget::takes(std::string_view packed) const
{
    return unpackedSize(packed).value_or(0) <= atOnce + perByte * m_read;
}

bool RecordingBudget::takesOf(std::string_view packed, std::uint64_t& sum, std::uint64_t base)
{
    if (!takes(packed))
        return false;
    sum += unpackedSize(packed).value_or(0);
    return sum <= base + perByte * m_read;
}

bool RecordedTime::takes(const StoredChunk& chunk)
{
    if (chunk.firstStep < 0 || chunk.firstStep > mostSteps || chunk.frameSteps.empty()
        || chunk.frameSteps.size() != chunk.frameTimes.size() || chunk.hashes.empty())
        return false;
    const std::int64_t lastStep = chunk.firstStep + std::int64_t(chunk.hashes.size()) - 1;
    const double timeStep = m_timeSteps[std::size_t(chunk.design)];
    const bool follows = !m_last || chunk.firstStep == m_nextStep;
    if (!follows || !(timeStep > 0.0) || chunk.frameSteps.front() < chunk.firstStep
        || chunk.frameSteps.back() > lastStep)
        return false;
    // the design may have changed with the first step
    const auto [shortest, longest] = std::minmax(m_last ? m_timeStep : timeStep, timeStep);
    if (!goesOn(chunk.frameSteps.front(), chunk.frameTimes.front(), shortest, longest))
        return false;
    for (std::size_t i = 1; i < chunk.frameSteps.size(); ++i)
        if (!goesOn(chunk.frameSteps[i], chunk.frameTimes[i], timeStep, timeStep))
            return false;
    m_timeStep = timeStep;
    m_nextStep = lastStep + 1;
    return true;
}

bool RecordedTime::goesOn(std::int64_t step, double time, double shortest, double longest)
{
    if (!std::isfinite(time))
        return false;
    if (m_last) {
        const double steps = double(step - m_last->step);
        const double passed = time - m_last->time;
        if (steps < 0.0 || passed < steps * shortest / loosely
            || passed > steps * longest * loosely)
            return false;
    }
    m_last = {step, time};
    return true;
}

} // namespace ripstop
