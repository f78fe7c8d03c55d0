// What a control does: it moves particles and colliders, or shifts a weight between rods.
//
// The scene chooses it for each control; Input (system/input.h) carries it into the step.
#pragma once

#include "base/choice_names.h"

namespace ripstop {

enum class ControlKind { Move, WeightShift };
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<ControlKind>{"move", "weight_shift"};

} // namespace ripstop
