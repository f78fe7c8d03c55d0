// Runs a system until it hangs still.
//
// Still is what has moved slower than a threshold for half a swing, as all of it may stand for an
// instant at its turning point: in half a swing it has gone through its lowest point, where it is
// fastest. No part of a design swings slower under its weight than a pendulum as long as all of it
// is large, of which half a swing takes pi sqrt(L / g): 1 s at 1 m, 10 s at 100 m. Kinetic damping
// (Cundall 1976; Barnes 1999, "Form finding and analysis of tension structures by dynamic
// relaxation") shortens the way there: whenever the kinetic energy has passed a peak, everything is
// stopped and starts again from rest. It does not change where things hang, but the way there is no
// motion of the real thing.
#pragma once

#include "simulation/frame.h"

#include <cstdint>

namespace ripstop {

class Simulation;

struct SettleGoal
{
    double speed = 0.01;  // m/s, no free particle is faster
    double during = 0.5;  // s, at least; half a swing of something large takes longer
    double within = 60.0; // s of simulated time; then it gives up
    bool damped = false;  // by kinetic damping
    int number = 0;       // of the goal, copied into its frames

    friend bool operator==(const SettleGoal&, const SettleGoal&) = default;
};

class Settler
{
public:
    Settler(const SettleGoal& goal, const Simulation& simulation);

    // Call after each step. It may stop all motion. When it gives up, the speed in progress() is
    // the last one that was too fast.
    void look(Simulation& simulation);

    const Settling& progress() const { return m_progress; }
    bool isOver() const { return m_progress.outcome != Settling::Outcome::Under; }
    const SettleGoal& goal() const { return m_goal; }
    std::uint64_t run() const { return m_run; }

private:
    SettleGoal m_goal;
    Settling m_progress;
    double m_start = 0.0;   // s
    double m_still = 0.0;   // s, since when
    double m_during = 0.0;  // s, that it has to be
    double m_tooFast = 0.0; // m/s, of the last moment that was not
    double m_peak = 0.0;    // J, of the kinetic energy since the last halt
    int m_steps = 0;        // since then
    std::uint64_t m_run = 0;
};

} // namespace ripstop
