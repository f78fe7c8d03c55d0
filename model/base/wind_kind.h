// What winds blow: the same everywhere, by a profile over height, in turbulence, from a nozzle, or
// as single gusts of a known size. The formulas stand in base/airflow.h, forces/gusts.h and
// forces/discrete_gust.h.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class WindKind { Uniform, PowerLaw, LogLaw, Gusts, Jet, DiscreteGust };
template <>
inline constexpr std::array<std::string_view, 6> choiceNames<WindKind>{
    "uniform", "power_law", "log_law", "gusts", "jet", "discrete_gust"};

} // namespace ripstop
