// What a plot of a design shows its curves against: time, what a probe measures, or frequency.
// It is part of the scene (scene/items.h) and nothing of a run: no solver knows of it.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class PlotAxis { Time, Probe, Frequency };
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<PlotAxis>{"time", "probe",
                                                                       "frequency"};

} // namespace ripstop
