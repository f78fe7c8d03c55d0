// The last percent of an optimisation: from the best place of a global stage downhill, by BOBYQA
// (Powell 2009) where nothing constrains and by COBYLA (Powell 1994) where something does or there
// is one variable alone, which BOBYQA cannot have. Both are NLopt's and use no random numbers.
//
// NLopt asks for values in its own loop. So each step runs it again from the start with the values
// that are known, up to the first place whose value is not: a few thousand sums, and a search that
// was ended goes on where it was.
#pragma once

#include "study/particle_swarm.h"

#include <optional>

namespace ripstop {

class Polish
{
public:
    static bool isThere(); // whether NLopt was there when this was built

    //   constraints  how many with a limit a score has
    //   count        evaluations at most
    //   worst        the value of places where the flight was not whole or an outcome is not as
    //                wanted: outcomes have no slope to follow, and are a wall
    Polish(SharePlace start, std::size_t constraints, std::size_t count, double worst)
        : m_start(std::move(start))
        , m_constraints(constraints)
        , m_count(count)
        , m_worst(worst)
    {}

    std::optional<SharePlace> next() const;                         // nothing when it is over
    void tell(Score score) { m_known.push_back(std::move(score)); } // of next()

private:
    SharePlace m_start;
    std::size_t m_constraints;
    std::size_t m_count;
    double m_worst;
    std::vector<Score> m_known; // in the order in which they were asked for
};

} // namespace ripstop
