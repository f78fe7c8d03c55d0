// What winds blow: the same everywhere, by a profile over height, in turbulence, from a nozzle, as
// single gusts of a known size, or as somebody has measured it. The formulas stand in
// base/airflow.h, forces/gusts.h, forces/discrete_gust.h and system/wind_record.h.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class WindKind { Uniform, PowerLaw, LogLaw, Gusts, Jet, DiscreteGust, Measured };
template <>
inline constexpr std::array<std::string_view, 7> choiceNames<WindKind>{
    "uniform", "power_law", "log_law", "gusts", "jet", "discrete_gust", "measured"};

} // namespace ripstop
