// Lines that go slack and taut.
//
// A line is a chain of links that resist tension only, are not part of a fabric and have no rod
// alongside, from one thing that holds it to the next. What it bears is the largest tension of its
// links. It is slack when it bears less than its own weight or 1/200 of the most that it has borne,
// and taut when it bears more than twice that weight and 1/50 of the most; a change counts once it
// has lasted a while (outlast). The most is that of means over such a while, as the jerk of a stiff
// line in a single step says little. How lines are in the first tenth of a second is no event.
#pragma once

#include "recording/run_event.h"
#include "system/key.h"

#include <span>
#include <vector>

namespace ripstop {

class Simulation;
struct System;

struct Line
{
    Key key = 0;            // of its first link
    std::vector<int> links; // indices into System::links
    double weight = 0.0;    // N, at least a hundred-thousandth of that of all that can move

    double mean = 0.0;  // N, that it bears, lately
    double most = 0.0;  // N, of that mean
    double since = 0.0; // s, that it is as `taut` says
    bool taut = false;
    bool known = false; // which of both
};

std::vector<Line> linesOf(const System& system);

class SlackWatch
{
public:
    static constexpr double outlast = 0.05; // s

    void begin(double time); // s

    // After each step: adds one event for all lines that have gone slack, one for the taut.
    void look(const Simulation& simulation, std::vector<RunEvent>& events);

private:
    void prepare(const System& system);

    std::vector<Line> m_lines;
    int m_stride = 1; // steps, so that many lines cost little
    double m_begin = 0.0;
    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
};

} // namespace ripstop
