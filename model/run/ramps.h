// Edits in flight that do not come as a blow: what an edit changes of a link's numbers goes over
// into what was typed within System::rampTime.
//
// A line that gets a thousand times stiffer between two steps throws whatever it holds. So lengths,
// damping, tear limits and the way that a pull stretches a link (compliance; of springs 1 / k, or k
// where one end is 0) go from what they were to what was typed as s^2 (3 - 2 s) does from 0 to 1, s
// being the share of the time that has passed. A tear rule counts at once, with its own limit.
//
// A soft kite on a long line that is made stiff again has far to go: what its links have to shrink
// by, at most, times the size of what is edited. Where that way asks for more than 10 m/s, which
// the air would not take calmly, the ramps of the edit last longer.
//
// Ramps are a part of the State: a run from a checkpoint has the same bits. A system that runs has
// the numbers of the moment; the ends of its ramps are what it was compiled to.
#pragma once

#include "base/key_index.h"
#include "compile/patch.h"
#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

// The numbers of all links at a moment, noted before an edit.
class NotedLinks
{
public:
    // What is under way in the state counts as far as it has come.
    NotedLinks(const System& system, const State& state);

    // What is under way after the edit: new ramps to the numbers of `edited` where they are not
    // what they were, and old ones whose end it has left alone.
    std::vector<Ramp> rampsTo(const System& edited) const;

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

    double lastsFor(const System& edited, std::span<const Ramp> ramps,
                    std::span<const LinkKind> kind, const KeyIndex& noted) const;
    double m_time;             // s
    std::vector<Link> m_links; // [links]
    std::vector<Ramp> m_ramps; // under way
};

// The numbers of ramps at a time, s, for a system that has their links.
Patch rampsAt(const System& system, std::span<const Ramp> ramps, double time);

// Those at which all have come to their ends.
Patch endsOf(const System& system, std::span<const Ramp> ramps);

// Drops those that have come to their ends.
void dropEnded(std::vector<Ramp>& ramps, double time);

} // namespace ripstop
