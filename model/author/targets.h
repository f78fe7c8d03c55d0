// What a part or a group comes to, beside what its author wants it to come to: mass, length of
// line and area of panels, each in the unit of its property. The inspector shows them; targets are
// authored numbers of a part or group and no simulation depends on them.
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <vector>

namespace ripstop {

enum class TargetOf { Mass, Length, Area };

struct Target
{
    const Property* property; // mass, length or area; its unit is that of the numbers
    double value;             // of now
    double wanted;
    TargetOf of;

    double excess() const { return value - wanted; }
    // Whether the value is within half a percent of what is wanted.
    bool isMet() const;
};

// The targets that are set; none for an item without targets. For a group its members count, and
// particles that its links and panels lead to do not.
std::vector<Target> targetsOf(const Scene& scene, Id id);

// Spreads what is missing to the target mass, or is too much, over the particles in proportion to
// their masses. Fails with a sentence where there is no mass yet.
Result<Edit> massBroughtToTarget(const Scene& scene, Id id);

} // namespace ripstop
