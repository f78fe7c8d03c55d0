// What controls move: particles, colliders, or weights that rods hold.
//
// An Input is a control made ready to run. Its command and its value, both in m, stand in the State
// ([inputs]) and are moved on at the start of each substep (step/inputs.h).
#pragma once

#include "base/control_kind.h"
#include "base/vec3.h"
#include "system/key.h"

#include <vector>

namespace ripstop {

// One input, a length along an axis.
struct Input
{
    Key key;
    ControlKind kind;
    Vec3 axis;                       // unit
    double limit;                    // m
    double rate;                     // m/s
    double automaticRate;            // m/s
    std::vector<int> targets;        // particle indices
    std::vector<int> obstacles = {}; // that it moves, indices

    friend bool operator==(const Input&, const Input&) = default;
};

// A rod whose rest length follows the weight shift of one of its ends:
// it is scaled by |anchor - sum of (value x axis) over the inputs that shift `weight`| / |anchor|.
struct ShiftedRod
{
    int rod;
    int weight;  // the particle that is shifted
    Vec3 anchor; // m, from the weight to the other end, in the design

    friend bool operator==(const ShiftedRod&, const ShiftedRod&) = default;
};

} // namespace ripstop
