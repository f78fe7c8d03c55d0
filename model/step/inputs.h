// Inputs: the pilot's hands. A value follows its command at a limited rate in simulated time, so a
// design answers the same way whatever the speed of the machine or of the key repeat.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// Moves commands and values on by h seconds. Targets of an input that moves are carried along
// without gaining speed: position and previous position move together.
// Returns whether a value changed.
bool moveInputs(const System& system, State& state, double h);

// Moves what hands carry on by h seconds: after the hand in about 50 ms, at 10 m/s at most, so that
// it pushes what is in its way and does not throw it.
void moveCarried(State& state, double h);

// Rest length of every rod with the weight shifts of `state`.
//   restLength  [rods]  m
void fillRestLengths(const System& system, const State& state, std::span<double> restLength);

// The same for rods with a weight shift only; others are left alone.
void shiftRestLengths(const System& system, const State& state, std::span<double> restLength);

} // namespace ripstop
