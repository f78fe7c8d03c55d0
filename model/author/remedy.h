// What makes a value count that does nothing as things are (usage.h): widths for links, panels that
// carry, a tear rule, another solver.
//
// A remedy is a row of a table: what it is called on a button, the reasons that it takes away, and
// the edit that it makes. Forms offer those of a value beside it.
#pragma once

#include "base/result.h"
#include "scene/usage.h"

#include <string_view>
#include <vector>

namespace ripstop {

struct Remedy
{
    Message label;                         // "Give its links widths from the mesh"
    std::vector<std::string_view> reasons; // that it takes away (scene/idle_reasons.h)
    // Whether it can be done for this thing, where one of the reasons holds.
    bool (*fits)(const Property& property, const ConstRef& thing, const Circumstances& around);
    // For all of these things, which are of the property's kind. Fails with a sentence.
    Result<Edit> (*edit)(const Scene& scene, const Property& property, const std::vector<Id>& ids);
};

// The remedies for this property of this thing, best first; none where it has an effect.
std::vector<const Remedy*> remediesOf(const Scene& scene, const Usage& usage,
                                      const Property& property, Id id);

} // namespace ripstop
