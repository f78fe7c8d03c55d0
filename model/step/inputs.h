// Inputs: the pilot's hands. A value follows its command at a limited rate in simulated time, so a
// design answers the same way whatever the speed of the machine or of the key repeat.
#pragma once

#include "system/system.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ripstop {

// Moves commands and values on by h seconds. Targets of an input that moves are carried along
// without gaining speed: position and previous position move together.
// Returns whether a value changed.
bool moveInputs(const System& system, State& state, double h);

// The way of the pins that inputs move, in one substep. They never have a velocity, and what is
// damped at them is stretched by their way all the same: without it cloth that is drawn would be
// damped beside its edge as if the edge stood still and the cloth came back.
class PinWays
{
public:
    void reserve(const System& system); // takes memory; nothing else does

    // Before inputs move: where the pins are.
    void note(const System& system, const State& state);

    // While rods and panels are solved: where the pins were h seconds ago and, as if they came from
    // afar at that speed, how fast. All else sees pins that were there already.
    //   before  [particles] m
    void lookBack(State& state, std::span<PaddedVec3> before, double h) const;
    void forget(State& state, std::span<PaddedVec3> before) const;

private:
    struct Pin
    {
        std::size_t particle;
        Vec3 place; // m
    };
    std::vector<Pin> m_pins; // each once for each input that moves it
};

// Moves what hands carry on by h seconds: after the hand in about 50 ms, at 10 m/s at most, so that
// it pushes what is in its way and does not throw it.
void moveCarried(State& state, double h);

// Rest length of every rod with the weight shifts of `state`.
//   restLength  [rods]  m
void fillRestLengths(const System& system, const State& state, std::span<double> restLength);

// The same for rods with a weight shift only; others are left alone.
void shiftRestLengths(const System& system, const State& state, std::span<double> restLength);

} // namespace ripstop
