// All forces, and what is asked of all of them at once.
//
// Their order is that of ForceLists (system/force_lists.h). Whoever steps or keeps a ledger has
// Forces of its own, as they hold scratch and belong to one thread; whoever only asks uses
// knownForces().
#pragma once

#include "forces/force.h"

#include <string>
#include <vector>

namespace ripstop {

class SpringForce;

class Forces
{
public:
    Forces();
    ~Forces();
    Forces(Forces&&) noexcept;
    Forces& operator=(Forces&&) noexcept;

    auto begin() const { return m_all.begin(); }
    auto end() const { return m_all.end(); }
    std::size_t size() const { return m_all.size(); }

    // What springs pulled with at the last fill(), which tearing looks at.
    //   [springs]  N, on end `a`
    std::span<const PaddedVec3> ofSprings() const;

private:
    std::vector<std::unique_ptr<Force>> m_all;
    const SpringForce* m_springs; // the one among m_all that is of springs
};

// One set for all, for functions that are const; any thread may ask it.
const Forces& knownForces();

// Fills anew what forces derive from what was edited, and what gusts begin with. Returns whether
// the longest substep may be another one now. Only the single owner of a system may call it, and
// not beside a step.
bool listForces(System& system, const Edited& edited);

// The longest substep, s, at which all that is stiff is sure to be stable (laws/step_limit.h);
// infinite where nothing bounds the substep.
double stiffStepLimit(const System& system);

// The names of the forces that bound it, such as "bending"; empty where nothing does.
Message boundingForces(const System& system);

// The longest substep, s, that is sure to be stable for what forces take from motion, as that is in
// `state`; infinite where they take nothing.
//   damping  scratch
double dampingStepLimit(const System& system, const State& state, Damping& damping);

// Fills in what all forces take from motion, as that is in `state`.
void fillDamping(const System& system, const State& state, Damping& damping);

} // namespace ripstop
