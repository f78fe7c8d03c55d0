// What air does to fabric: the laws that a design chooses for each material, and whose formulas
// stand in forces/panel_load.h.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class AirLaw { None, Paper, LinearNormal, LiftDrag, Vortex };
template <>
inline constexpr std::array<std::string_view, 5> choiceNames<AirLaw>{
    "none", "paper", "linear_normal", "lift_drag", "vortex"};

} // namespace ripstop
