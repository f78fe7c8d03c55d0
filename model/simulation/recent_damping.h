// What the time steps have taken from the motion of the last ten seconds
// (step/numerical_damping.h): as a damping ratio, and as a share of its energy where the motion
// dies away by it. A ratio that is small in each swing is all of the motion after many of them.
#pragma once

#include "step/numerical_damping.h"

#include <array>
#include <cstddef>

namespace ripstop {

class RecentDamping
{
public:
    // After each step, of which `state` is the end. What was ten seconds before is forgotten, to a
    // second, so that what has come to rest is not said to be damped.
    void add(const NumericalDamping& step, const System& system, const State& state);

    // 1, of the critical; 0 of what hardly moves, as lost() is: how the rest of a motion dies away
    // is no loss.
    double ratio() const;

    // 1, of the energy of the motion, that the steps took in full seconds, where it is about what
    // energy has become less by in either half of them; else 0: what wind and hands keep going has
    // more to live on, and where dampers, air or obstacles take most, steps matter little. What was
    // there is what is left in the mean of the last full second, and what was taken.
    double lost() const;

private:
    struct Second
    {
        NumericalDamping damping; // J
        double motion = 0.0;      // J s
        double mass = 0.0;        // kg s, of what may move
        double length = 0.0;      // s
        double less = 0.0;        // J, by which all energy has become less
    };
    bool moves() const;
    const Second& before(std::size_t age) const // 1 for the last full one
    {
        return m_seconds[(m_now + m_seconds.size() - age) % m_seconds.size()];
    }

    std::array<Second, 10> m_seconds;
    std::size_t m_now = 0;  // the one that grows
    std::size_t m_full = 0; // before it
    double m_energy = 0.0;  // J, where it began
    bool m_hasBegun = false;
};

} // namespace ripstop
