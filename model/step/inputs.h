// Inputs: the pilot's hands. A value follows its command at a limited rate in simulated time, so a
// design answers the same way whatever the speed of the machine or of the key repeat.
#pragma once

#include "system/system.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ripstop {

// Moves commands and values on by h seconds. Targets of an input that moves are carried along
// without gaining speed: position and previous position move together. How fast pins are, PinWays
// says.
// Returns whether a value changed.
bool moveInputs(const System& system, State& state, double h);

// The way of the pins that inputs move, in one substep. Nothing accelerates them, so this is all
// that tells how fast they are: to dampers, the air and friction, which would take them for
// standing still, and to what is damped while it is stretched by their way.
class PinWays
{
public:
    void reserve(const System& system); // takes memory; nothing else does

    // Before inputs move: where the pins are.
    void note(const System& system, const State& state);

    // After inputs have moved: how fast, m/s, the pins came h seconds long to where they are.
    void giveVelocities(State& state, double h) const;

    // While rods and panels are solved: where the pins were h seconds ago and, as if they came from
    // afar at that speed, how fast. All else sees pins that were there already. What lets one go
    // then, as a tear does, finds a particle that has always come so fast.
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
