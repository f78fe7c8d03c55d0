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

// The way of the pins that inputs move, in one substep. They stand still for the integrator, and
// what is damped at them is stretched by their way all the same: without it a drawn sheet would be
// damped where it hangs, as if its edge had been let go.
class PinWays
{
public:
    void reserve(const System& system); // takes memory; nothing else does

    // Before inputs move and the integrator begins: where the pins are and what State::drift has of
    // the substep before.
    void note(const System& system, const State& state);

    // After the integrator has begun: puts both back, for those who look back.
    //   before  [particles] m
    void lookBack(State& state, std::span<PaddedVec3> before) const;

    // After rods are solved: State::drift of this substep of h seconds, for the next one.
    void keep(State& state, std::span<const PaddedVec3> before, double h) const;

private:
    struct Pin
    {
        std::size_t particle;
        Vec3 place; // m
        Vec3 drift; // m/s
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
