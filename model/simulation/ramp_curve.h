// How what an edit in flight changes goes over: the curve of all ramps, and how long they last.
//
// A number goes from what it was to what was typed as s^2 (3 - 2 s) does from 0 to 1, s being the
// share of the time that has passed: it begins and ends without a jerk.
//
// A soft kite on a long line that is made stiff again has far to go: the way is what its links and
// panels have to shrink by, at most, times the size of what is edited. A load that hangs so far
// down swings with a period of 2 pi sqrt(way / g). One that cannot follow is thrown by what the
// cloth still holds when it gets stiff, and so the ramps of the edit last at least half as long.
#pragma once

#include "base/vec3.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ripstop {

template <typename R>
bool hasEnded(const R& ramp, double time) // s
{
    return time >= ramp.began + ramp.lasts;
}

// How much of the way a ramp has come at a time, s: 0 to 1.
template <typename R>
double shareOf(const R& ramp, double time)
{
    if (hasEnded(ramp, time))
        return 1.0;
    const double s = std::max((time - ramp.began) / ramp.lasts, 0.0);
    return s * s * (3.0 - 2.0 * s);
}

inline double between(double from, double to, double share) { return from + share * (to - from); }

// By its inverse, so that what hangs on it goes evenly; where one of the two is none, by itself.
inline double stiffnessBetween(double from, double to, double share)
{
    return from > 0.0 && to > 0.0 ? 1.0 / between(1.0 / from, 1.0 / to, share)
                                  : between(from, to, share);
}

// What is edited at once, and how far it has to go.
struct RampWay
{
    Eigen::AlignedBox3d box; // m, around what is edited
    double strain = 0.0;     // 1, the largest change of a length over that length

    double lastsFor(double rampTime) const // s
    {
        constexpr double g = 9.8; // m/s^2; what flies is held by about its weight, or pulled harder
        const double way = box.isEmpty() ? 0.0 : strain * box.diagonal().norm(); // m
        return std::max(rampTime, std::numbers::pi * std::sqrt(way / g));
    }
};

// Finds the ramps of keys, of which there may be a hundred thousand. Keys that are asked about in
// ascending order, as those of a part mostly are, need no search.
template <typename R, typename K>
class RampFinder
{
public:
    //   ramps  in ascending order of `key`; must outlive this
    RampFinder(const std::vector<R>& ramps, K R::*key)
        : m_ramps(ramps)
        , m_key(key)
    {}

    const R* operator()(const K& wanted) // or null
    {
        if (!isNext(wanted))
            m_next =
                std::size_t(std::ranges::lower_bound(m_ramps, wanted, {}, m_key) - m_ramps.begin());
        const bool isThere = m_next < m_ramps.size() && m_ramps[m_next].*m_key == wanted;
        return isThere ? &m_ramps[m_next++] : nullptr;
    }

private:
    bool isNext(const K& wanted) const
    {
        return (m_next == 0 || m_ramps[m_next - 1].*m_key < wanted)
               && (m_next == m_ramps.size() || !(m_ramps[m_next].*m_key < wanted));
    }

    const std::vector<R>& m_ramps;
    K R::*m_key;
    std::size_t m_next = 0; // the first that is not below the key asked about last
};

} // namespace ripstop
