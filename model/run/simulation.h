// A system in motion: state, stepper and watchdog together. The runner thread, the command line
// and the exporters all drive one of these, so that they get the same bits.
#pragma once

#include "compile/live_system.h"
#include "measure/energy_ledger.h"
#include "run/frame.h"
#include "run/probe_reader.h"
#include "run/run_input.h"
#include "step/stepper.h"
#include "step/watchdog.h"

#include <map>
#include <memory>
#include <optional>

namespace ripstop {

// Where the controls are told to go, m, by the id of the control. Controls that are not named keep
// what they were told before.
using Commands = std::map<std::uint32_t, double>;

// Whether the time step that is nearest to `until` has been reached. Midway between two steps it is
// the earlier one, and round-off does not decide.
bool hasReached(double time, double until, double timeStep); // s

class Simulation
{
public:
    explicit Simulation(std::shared_ptr<const System> system, int threads = 1);

    // Goes on from a checkpoint: the state of a simulation of this system.
    Simulation(std::shared_ptr<const System> system, State checkpoint, int threads = 1);

    // Goes on with an edited system. The motion carries over unless its run number differs.
    void load(std::shared_ptr<const System> system);

    // Goes on after an edit. A patch changes the system in place and leaves it with the same bits
    // as loading the compiled scene; the system is copied first if anyone else holds it.
    void load(const Update& update);

    void command(const Commands& commands);

    // Takes effect at once; cuts and halts are those since the start of the run, and are made once.
    void handle(const HandCommands& told);

    void halt(); // stops all motion; it starts again from rest

    // Goes on from a moment of another run, with the motion of what both have: to the same bits
    // when nothing was edited since. What was done in this run is forgotten.
    void resume(const Moment& moment);

    // Shows another instant of the same system, for who has kept it; no step follows.
    void place(State state);

    // Adds what commands and hands change from now on; null stops that.
    void keepInputs(std::vector<RunInput>* inputs) { m_inputs = inputs; }

    // One time step. False, and the last good state stays, when the next one would be broken;
    // trouble() then says why.
    bool step();

    // Steps until `time`, s, is reached, as hasReached() has it.
    bool runUntil(double time);

    // Adds what each stage of the steps from now on takes; null stops that.
    void keepTimes(StepTimes* times) { m_stepper.keepTimes(times); }

    // What runs: the system that was loaded, or what tears have made of it (split_system.h).
    const System& system() const { return m_split ? *m_split : *m_system; }
    const std::shared_ptr<const System>& compiled() const { return m_system; }
    const State& state() const { return m_state; }
    std::span<const std::uint32_t> touches() const { return m_stepper.touches(); }
    const std::optional<Trouble>& trouble() const { return m_trouble; }

    std::shared_ptr<Frame> frame() const; // a new one, the caller's own
    ProbeSample sample() const;           // its probes alone

private:
    void apply(const Patch& patch);
    void applySplit(bool again);
    void reset(const Patch& patch);
    System& ownSystem();
    void carryOn(const System& before);
    void forget();
    void handle(const Hands& told);
    void carry(const std::vector<Carry>& told);
    void pin(const std::vector<Key>& told);
    void cut(const std::shared_ptr<const Cut>& cut);
    void stopMotion();
    void note(HandNote::What what);
    Readings readings() const;
    double substep() const; // s, of the next step
    void fillHands(Frame& frame) const;
    void followTears(std::size_t before);
    void refreshLayout() const;

    std::shared_ptr<const System> m_system; // as compiled
    // m_system as tears have split it and hands have pinned it; null when neither did
    std::shared_ptr<const System> m_split;
    mutable std::shared_ptr<const Layout> m_layout; // of the system unless stale
    mutable bool m_layoutIsStale = false;
    State m_state;
    State m_lastGood;
    mutable ProbeReader m_probes;
    bool m_atStart = true;                  // the state is the system's start
    std::vector<ControlCommand> m_commands; // since the start
    HandTrack m_hands;                      // the same
    std::size_t m_cuts = 0;                 // made since the start
    int m_halts = 0;
    std::vector<RunInput>* m_inputs = nullptr;
    Stepper m_stepper;
    EnergyLedger m_ledger;
    std::optional<Trouble> m_trouble;
};

} // namespace ripstop
