// The choice that Solver::Auto makes: how many substeps of one sweep hold the rods to the strain
// that is wanted, and which rods a direct block holds instead.
//
// A sweep finds a rod that carries the load F stretched by F h^2 (wa + wb), w the inverse masses of
// its ends and h the substep. So what holds the fabric decides. At a particle of mass m in a
// network of mass M, what rods join, the load is 2 g times the lighter of m and M - m, shared by
// its rods; all of M is shared by the rods of all that is pinned. The worst rod, of length L, then
// keeps within the strain e in
//
//     n = 1.5 T sqrt(F (wa + wb) / (e L))
//
// substeps of the step T; 1.5 is what square cloths of 10 to 100 particles a side need. Where n is
// above 100 in 10 ms, and a direct block (direct_choice.h) can have such rods, it gets them; small
// kites and gliders, and all lines, go there as a whole.
//
// A rod of compliance c it finds softer by the share h^2 (wa + wb) / c. Where that takes more than
// 40 substeps to come down to the wanted accuracy, all rods of the network go to the global solve
// (direct_solver.h), whose cost does not depend on the stiffness; cloth of real fabric does.
//
// Stiff forces, as bends, bound the substep themselves (forces/forces.h).
//
// The automatic integrator takes BDF2 where all rods are solved together, what is not solved with
// them, as bends of cloth, swings so slowly that two time steps would be stable, and nothing rings
// without being damped. One substep is then as true as four of Euler's, so that a quarter of
// System::substeps are enough, and half of them for what swings on without a damper. Cloth and nets
// without one, above all those that never stretch, ring like bells with nothing to calm them but
// what Euler loses, and keep it; pendulums, ties and spars that are held by one end only swing.
// BDF2 that the author wants gets all rods solved together, since it makes what a single sweep
// leaves over grow.
//
// That is the start. While a system runs, the strain is looked at every few steps and the number of
// substeps follows it (adaptedSubsteps): wind and swings load rods as well.
#pragma once

#include "base/message.h"
#include "forces/force.h"
#include "system/system.h"

#include <span>
#include <vector>

namespace ripstop {

struct SolverPlan
{
    Integrator integrator = Integrator::SemiImplicitEuler; // any but Auto
    int substeps = 1;                                      // to begin with
    int least = 1;                    // that the author wants, and that stiff forces allow
    std::vector<std::uint8_t> direct; // [rods], for System::direct; empty for none
    bool together = false;            // these are all rods that can move
    Message reason;                   // what was chosen and why, for people; one sentence
};

// Tells whether a plan still holds.
class PlanFor
{
public:
    PlanFor() = default;
    explicit PlanFor(const System& system)
        : m_serial(system.serial)
        , m_valuesSerial(system.valuesSerial)
        , m_timeStep(system.timeStep)
        , m_strainGoal(system.strainGoal)
        , m_accuracy(system.accuracy)
        , m_gravity(system.gravity.norm())
        , m_substeps(system.substeps)
        , m_integrator(system.integrator)
    {}
    bool isOf(const System& system) const { return *this == PlanFor(system); }

private:
    friend bool operator==(const PlanFor&, const PlanFor&) = default;

    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
    double m_timeStep = 0.0;
    double m_strainGoal = 0.0;
    double m_accuracy = 0.0;
    double m_gravity = 0.0;
    int m_substeps = 0;
    Integrator m_integrator = Integrator::Auto;
};

// The system must be finished.
SolverPlan planFor(const System& system);

// Fewest substeps for what forces, air above all, take from the motion that is in `state`, with a
// half to spare for what they do in the next few steps. Rods that are solved directly say nothing
// of it by their strain. Where that joins the masses, what is left is how loads turn with the
// cloth.
int substepsForDamping(const System& system, const State& state, bool joinsMasses,
                       Damping& scratch);

// Substeps of the next step, no fewer than `least`, given those of the last and how often the error
// that they left is as large as it may be (StepAccuracy::ratio()).
int adaptedSubsteps(int substeps, int least, double ratio);

} // namespace ripstop
