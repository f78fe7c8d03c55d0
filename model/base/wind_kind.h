// What winds blow: the same everywhere, by a profile over height, in gusts, or from a nozzle. The
// formulas stand in base/airflow.h and forces/gusts.h.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class WindKind { Uniform, PowerLaw, LogLaw, Gusts, Jet };
template <>
inline constexpr std::array<std::string_view, 5> choiceNames<WindKind>{"uniform", "power_law",
                                                                       "log_law", "gusts", "jet"};

} // namespace ripstop
