// What runs: a system as it was compiled, or what tears, cuts and pins have made of it.
//
// A compiled system is never split itself. What has happened to it stands in the state of the run,
// as splits and pins by keys, and the derived system is made of both (assembly/split_system.h), so
// that a checkpoint, an edit and another number of threads come to the same bits:
//
//     compiled ----------------- no splits, no pins ---------------------> runs itself
//     compiled + State::splits + State::hands.pins --- splitSystem() ----> derived, which runs
//
// Whenever one of the three changes, the derived system is made anew and the motion of the one
// before is carried over into it (assembly/carry_over.h). Belongs to a Simulation and is called by
// whoever steps that.
#pragma once

#include "simulation/frame.h"
#include "system/state.h"

#include <memory>

namespace ripstop {

struct Moment; // system/moment.h
struct Patch;  // compile/patch.h
struct System; // system/system.h

// The motion of a run.
struct RunState
{
    State now;
    State lastGood;      // a step earlier, while steps are made; or memory for the next one
    bool atStart = true; // `now` is the start of the compiled system: nothing has been done yet
};

class DerivedSystem
{
public:
    // A system at its start.
    explicit DerivedSystem(std::shared_ptr<const System> compiled);

    // A system that a state has gone on from.
    DerivedSystem(std::shared_ptr<const System> compiled, const State& state);

    const System& system() const { return m_derived ? *m_derived : *m_compiled; } // what runs
    const std::shared_ptr<const System>& compiled() const { return m_compiled; }

    // Another compiled system in place of this one. Returns what ran before, for carryOn().
    std::shared_ptr<const System> replace(std::shared_ptr<const System> compiled);

    // Changes the compiled system in place; it is copied first if anyone else holds it. Returns
    // what was derived of it and is no more, for carryOn(); null when nothing was.
    std::shared_ptr<const System> apply(const Patch& patch);

    // The system that the state asks for, without a motion to keep.
    void derive(const State& state);

    // The motion of the system before, in the one that splits and pins make of the compiled one.
    void carryOn(const System& before, RunState& run);

    // The same after splits or pins have changed.
    void deriveAnew(RunState& run);

    // The motion of a moment of another run, in this system.
    void goOnFrom(const Moment& moment, RunState& run);

    // Opens the mesh between two steps, where links have torn in the last; `before` it there were
    // so many tears.
    void followTears(std::size_t before, RunState& run);

    // What frames say of the system. Views build what they draw from it, and most edits change
    // numbers and leave it as it is: it is the same object then.
    const std::shared_ptr<const Layout>& layout(const State& state);

private:
    System& own();

    std::shared_ptr<const System> m_compiled;
    std::shared_ptr<const System> m_derived; // null when there are neither splits nor pins
    std::shared_ptr<const Layout> m_layout;  // of the system unless stale
    bool m_layoutIsStale = false;
};

} // namespace ripstop
