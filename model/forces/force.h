// The record of a force: all that the program asks about it, in one place.
//
// The stepper, the energy ledger, the energies, the choice of substeps and edits in place walk the
// list of forces (forces.h) and name none of them. A new force is
//
//   - what it derives from a system, as a type in system/force_lists.h, which puts it on the list;
//   - a class of its own in a source of this room, and makeForce() for that type.
//
// All functions work on whole arrays; none is called for a single element. A Force holds scratch
// arrays only: what moves stands in State, what stays in System. Functions that are const use no
// scratch and may be called from any thread.
//
// tests/model/test_forces.cpp compares each force with its energy or its work by differences, and
// has to be shown an example of it.
#pragma once

#include "base/message.h"
#include "forces/lane.h"
#include "parallel/thread_pool.h"
#include "system/system.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

// By how much forces fall for each m/s that a particle moves faster, as things are in a state.
struct Damping
{
    std::vector<Mat3> at; // [particles] N s/m, symmetric, and never less than 0 in any direction
    std::vector<PaddedVec3> more, less; // scratch
};

// Where the work of a force goes, which the energy ledger, the energies and the clock of a step
// sort by.
enum class ForceKind {
    Elastic, // the design's own: energy() holds it, and what dampers take is counted as damping
    Weight,  // energy() holds it, by height and the like
    Air,     // work of the air: the sum of force times velocity over particles
    Hand     // work of hands: workSince() tells it
};

// What an edit has changed in a finished system.
struct Edited
{
    bool materials = false;
    bool particles = false; // masses, pins, where they start
    bool links = false;     // numbers of springs and rods
    bool linkStuff = false; // what links are made of
    bool panels = false;    // their materials
    bool winds = false;
    bool solver = false;
};

// Where particles were, and how fast.
struct MotionBefore
{
    std::span<const Vec3> position; // [particles] m
    std::span<const Vec3> velocity; // [particles] m/s
};

class Force
{
public:
    virtual ~Force() = default;

    // A name for people, as in "bending needs at least 12", where it bounds the substep.
    virtual Message name() const = 0;
    virtual ForceKind kind() const = 0;
    virtual bool acts(const System& system, const State& state) const = 0;

    // Whether it stays the same throughout a step, as gravity does.
    virtual bool isSteady() const { return false; }

    // --- what it derives from the rest of a system (force_lists.h) ----------------------------
    virtual bool hangsOn(const Edited&) const { return false; }
    virtual void list(System&) const {}

    // --- the force ----------------------------------------------------------------------------
    // Takes all the memory that a step needs; nothing else does once this was called.
    virtual void prepare(const System&, const State&) {}

    // Moves what the force itself remembers on by a substep of h, s; before fill().
    virtual void advance(const System&, State&, double) {}

    // Computes it for each of its elements. What it points to holds until the next call.
    virtual Lane fill(const System&, const State&, ThreadPool&) { return {}; }

    // What every particle gets alike, m/s^2.
    virtual Vec3 acceleration(const System&) const { return Vec3::Zero(); }

    // A force that acts on a few particles, or depends on the substep of h, s, adds its
    // accelerations here to the sum of all others; it needs no elements.
    //   acceleration  [particles]  m/s^2
    virtual void addToFew(const System&, const State&, double, std::span<PaddedVec3>) {}

    // --- energy and work ----------------------------------------------------------------------
    virtual double energy(const System&, const State&) const { return 0.0; } // J, that it holds

    // Power, W, at most 0, that a force which holds energy takes by damping.
    virtual double dampingPower(const System&, const State&, ThreadPool&) { return 0.0; }

    // Work, J, that pinned ends have put into the force by moving since `before`, all else being
    // where it was.
    virtual double workOfPins(const System&, const State&, const MotionBefore&) const
    {
        return 0.0;
    }

    // Work, J, done since the call before or since startWork(), which is called before a step with
    // substeps of h, s. It is for a force that knows the way that its point of attack goes.
    virtual void startWork(const System&, const State&, double) {}
    virtual double workSince(const System&, const State&, double) { return 0.0; }

    // --- how long a substep may be --------------------------------------------------------------
    // Whether the automatic solver keeps to the limit by itself. Springs leave it to the author.
    virtual bool boundsSubstep(const System&) const { return false; }

    // Whether some of it is no force, but solved together with the rods.
    virtual bool joinsRods(const System&) const { return false; }

    // Adds what it asks of the step (laws/step_limit.h) at each particle.
    //   stiffness, damping  [particles]  N/m, N s/m
    virtual void addStiffness(const System&, std::span<double>, std::span<double>) const {}

    // Adds what it takes from the motion that is in a state.
    virtual void addDamping(const System&, const State&, Damping&) const {}

    // No solver asks for the stiffness between particles; an implicit one would ask for it here.
};

} // namespace ripstop
