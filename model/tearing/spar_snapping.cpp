#include "tearing/spar_snapping.h"

#include "forces/bend_force.h"
#include "tearing/tearing.h"

#include <algorithm>

namespace ripstop {
namespace {

bool isAt(const Bend& spar, int link) { return spar.of[0] == link || spar.of[1] == link; }

// N m, at the other ends of a link of the spar; less than none where the link is clamped.
double momentBeyond(const System& system, const State& state, const Bend& spar, int link)
{
    const LinkPlace& ends = system.links[std::size_t(link)];
    const auto isPinned = [&](int p) { return system.inverseMass[std::size_t(p)] == 0.0; };
    if (isPinned(ends.a) && isPinned(ends.b))
        return -1.0;
    double most = 0.0;
    for (const Bend& other : system.of<BendLists>().ofSpars())
        if (isAt(other, link) && &other != &spar)
            most = std::max(most, bendingMoment(system, state, other));
    return most;
}

} // namespace

double snapRatio(const System& system, const State& state, const Bend& spar)
{
    return spar.breaking > 0.0 ? bendingMoment(system, state, spar) / spar.breaking : 0.0;
}

bool snap(const System& system, State& state, const Bend& spar)
{
    if (isCut(system, state, spar))
        return false;
    const double moment = bendingMoment(system, state, spar);
    const bool isSecond = momentBeyond(system, state, spar, spar.of[1])
                          > momentBeyond(system, state, spar, spar.of[0]);
    const int link = spar.of[isSecond ? 1 : 0];
    double released = 0.0;
    for (const Bend& other : system.of<BendLists>().ofSpars())
        if (isAt(other, link) && !isCut(system, state, other))
            released += energyOf(other, waysOf(other, state));
    breakLink(system, state, link);
    State::Tear& told = state.tears.back();
    told.energy += released;
    told.length = 0.0; // tells that the force is a moment
    told.force = moment;
    told.place = state.position[std::size_t(spar.corner[0])];
    return true;
}

} // namespace ripstop
