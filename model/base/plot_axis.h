// What a plot of a design shows its curves against. No solver knows of it.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class PlotAxis { Time, Probe, Frequency }; // what a plot shows its curves against
template <>
inline constexpr std::array<std::string_view, 3> choiceNames<PlotAxis>{"time", "probe",
                                                                       "frequency"};

} // namespace ripstop
