// Which parts touch which colliders, and when that begins and ends. Called after each step, on the
// thread that steps; it looks and changes nothing.
#pragma once

#include "recording/run_event.h"
#include "system/key.h"

#include <vector>

namespace ripstop {

class Simulation;
struct System;

// A part touches from the first step in which one of its particles meets the collider, until none
// has for some time (outlast): what rests on the ground bounces by fractions of a millimetre. Of
// the first 32 colliders.
class TouchWatch
{
public:
    static constexpr double outlast = 0.05; // s

    // Parts that touch already are taken note of without an event.
    enum class Begin { Untouched, AsItIs };
    void begin(Begin how);

    // After each step: adds what has begun or ended in it.
    void look(const Simulation& simulation, std::vector<RunEvent>& events);

private:
    struct Pair
    {
        Key part = 0;
        Key collider = 0;
        bool touches = false;
        double last = 0.0; // s, when it did
    };
    void prepare(const System& system);

    std::vector<Pair> m_pairs;   // collider by collider for each part
    std::size_t m_particles = 0; // without those that tears have added
    std::uint64_t m_serial = 0;
    bool m_quietly = false;
};

} // namespace ripstop
