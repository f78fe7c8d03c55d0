// Probes for what is selected: whether a quantity can be measured on it, what it asks for in
// words, and the edit that adds the probe. The menu of measurements and the table of elements use
// it.
#pragma once

#include "scene/edit.h"

#include <optional>
#include <string>
#include <vector>

namespace ripstop {

// The edit that adds a probe of a quantity, and the id that the probe gets. Where two or three
// particles are measured together, a selection of as many gives them in the order of their ids.
// Several elements become a group, named after the probe. Nothing where the quantity cannot be
// measured on what is selected: `asks` says of what it can.
struct ProbeEdit
{
    Edit edit;
    Id probe{};
};
std::optional<ProbeEdit> withProbe(const Scene& scene, Quantity quantity,
                                   const std::vector<Id>& selected);

// "particles", "two particles", ...: what a quantity is measured on.
std::string asks(Quantity quantity);

// Whether withProbe() gives something.
bool isMeasurable(const Scene& scene, Quantity quantity, const std::vector<Id>& selected);

} // namespace ripstop
