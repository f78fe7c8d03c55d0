// Edits in flight that do not come as a blow: what an edit changes of the numbers of links and of
// elastic panels goes over into what was typed within System::rampTime.
//
// A line that gets a thousand times stiffer between two steps throws whatever it holds. So lengths,
// damping, tear limits and the way that a pull stretches a link (compliance; of springs 1 / k, or k
// where one end is 0) go from what they were to what was typed, along the curve and within the time
// of ramp_curve.h; the laws and cuts of panels do so with them (cloth_ramps.h). A tear rule counts
// at once, with its own limit.
//
// Ramps are a part of the State: a run from a checkpoint has the same bits. A system that runs has
// the numbers of the moment; the ends of its ramps are what it was compiled to.
#pragma once

#include "base/key_index.h"
#include "compile/patch.h"
#include "simulation/cloth_ramps.h"
#include "system/system.h"

#include <vector>

namespace ripstop {

// The numbers of all links and elastic panels at a moment, noted before an edit.
class NotedNumbers
{
public:
    // What is under way in the state counts as far as it has come.
    NotedNumbers(const System& system, const State& state);

    // Puts into `state` what is under way after the edit: new ramps to the numbers of `edited`
    // where they are not what they were, and old ones whose end it has left alone.
    void rampTo(const System& edited, State& state) const;

private:
    struct Link
    {
        Key key;
        LinkKind kind;
        TearRule rule;
        Resists resists;
        Vec3 ends[2]; // m
        Ramp::Numbers numbers;
    };

    std::vector<Ramp> linkRampsTo(const System& edited, RampWay& way) const;
    void addTo(RampWay& way, const Ramp& ramp, LinkKind kind, const Link& link) const;

    double m_time;             // s
    std::vector<Link> m_links; // [links]
    std::vector<Ramp> m_ramps; // under way
    NotedCloth m_cloth;
};

// Whether anything is under way.
bool hasRamps(const State& state);

// The numbers of the ramps of a state at a time, s, for a system that has their links and panels.
Patch rampsAt(const System& system, const State& state, double time);

// Those at which all have come to their ends.
Patch endsOf(const System& system, const State& state);

// Drops those that have come to their ends.
void dropEnded(State& state, double time);

} // namespace ripstop
