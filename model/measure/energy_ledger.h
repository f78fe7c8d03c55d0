// Where energy comes from and where it goes: the work of all that is not the design itself, and
// what is left over when that is taken from the change of its energy.
//
// Whatever pushes a particle with the impulse J in a substep changes its kinetic energy by J.v, v
// the mean of its velocities at both ends; summed over all impulses this is exact. So for a force
// that is F0 at the start of a substep of h and F1 at its end the work is h (F0 + F1).v / 2, that
// of contact J.v, that of what is moved by hand, and pushes back with F, -F.x along its way x. A
// link that tears takes along what it held. What the balance leaves,
//
//     residual = change of kinetic, potential and elastic energy - work,
//
// is what integrator and projection have made (above 0) or lost: the drift of energy that Hairer,
// Lubich and Wanner 2006, chapter IX, judge integrators by, for systems that are driven and damped.
//
// Limits: rods pull at what is moved with their mean tension over the step, panels with the mean of
// both ends of the substep and the damping of their way between them, bends with that mean, and a
// control that moves what is not pinned is not asked about. Energy that an edit brings is no
// part of it.
#pragma once

#include "forces/forces.h"
#include "step/stepper.h"

#include <vector>

namespace ripstop {

// A step with a ledger takes two to four times as long.
bool isOfLedger(Quantity quantity);     // known only in runs that keep one
bool wantsLedger(const System& system); // a probe reads it

// Follows one step and adds to State::work; it holds scratch arrays only.
class EnergyLedger final : public SubstepWatch
{
public:
    void begin(const System& system, const State& state, double h); // a step with substeps of h, s
    void end(const System& system, State& state);                   // after it

    void beforeContact(const System& system, const State& state) override;
    void afterContact(const System& system, const State& state) override;
    void afterSolve(std::span<const HeldContact> contacts, double h, double reach) override;
    void afterSubstep(const System& system, const State& state, double h,
                      Integrator integrator) override;

private:
    struct Instant
    {
        std::vector<Vec3> position; // [particles] m
        std::vector<Vec3> velocity; // [particles] m/s
        std::vector<Vec3> air;      // [particles] N
        std::vector<Vec3> bending;  // [particles] N, or empty where nothing moves what bends
        double damping = 0.0;       // W, of dampers, at most 0
        bool hasPast = false;       // that BDF2 looks back to
    };

    void look(const System& system, const State& state, Instant& instant);
    void lookAtForces(const System& system, const State& state, Instant& instant);
    void addWorkOfHands(const System& system, const State& state, double h, Integrator integrator);
    double workOfDampers(const System& system, const State& state, double h) const;
    double workOnRods(const System& system, const State& state) const;
    double workOnPanels(const System& system, const State& state, double h) const;
    double workOnBends(const System& system) const;

    ThreadPool m_alone{1};
    Forces m_forces;
    Instant m_before; // at the start of the substep
    Instant m_after;
    std::vector<Vec3> m_seen;            // [particles] m, where springs have what is not pinned
    std::vector<Vec3> m_beforeContact;   // [particles] m/s
    std::vector<Vec3> m_contact;         // [particles] N s in this substep, or empty
    std::vector<PaddedVec3> m_stepStart; // [particles] m
    std::vector<double> m_restLength;    // [rods] m, at the start of the step
    std::vector<double> m_restLengthAfter;
    std::size_t m_tears = 0; // before the step
    double m_energy = 0.0;   // J, the same
    Work m_work;             // in the step
};

} // namespace ripstop
