// All forces, and what is asked of all of them at once.
//
// Their order is that of ForceLists (system/force_lists.h). Who steps or keeps a ledger has Forces
// of its own, as they hold scratch; who only asks uses knownForces().
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
    const SpringForce* m_springs; // of them
};

// For functions that are const.
const Forces& knownForces();

// Fills anew what forces derive from what was edited, and where gusts begin. Returns whether the
// longest substep may be another one now.
bool listForces(System& system, const Edited& edited);

// The longest substep, s, at which all that is stiff is sure to be stable (base/step_limit.h);
// infinite where nothing bounds the substep.
double stiffStepLimit(const System& system);

// What bounds it, as "bending"; empty without.
Message boundingForces(const System& system);

// The longest substep, s, that is sure to be stable for what forces take from motion, as that is in
// `state`; infinite where they take nothing.
//   rate  scratch
double dampingStepLimit(const System& system, const State& state, std::vector<double>& rate);

} // namespace ripstop
