// What hands did, as rows of a control track: TIME,@WORD,NUMBERS. A word says what the numbers are:
//
//     @pull     three particles, the share of each, x y z, stiffness, damping, most force
//     @let go
//     @pin, @unpin   a particle
//     @carry    a collider, x y z
//     @fan      x y z, velocity x y z, radius, widening
//     @fan off
//     @cut      near x y z, far x y z of each point of the stroke, two of them or more
//     @halt     of all motion
//
// hands.h says in which units. Particles are named by id, those that a tear or a cut has added by
// their key.
#pragma once

#include "base/result.h"
#include "simulation/hand_track.h"

#include <string>
#include <string_view>

namespace ripstop {

// The row after its time, without an end of line.
void appendHandRow(std::string& text, const HandNote::What& what);

inline bool isHandRow(std::string_view word) { return word.starts_with('@'); }

// `row` is what follows the time. A failure says how the message goes on after the place.
Result<HandNote::What> handOf(std::string_view row);

} // namespace ripstop
