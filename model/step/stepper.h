// The step: advances a State by one time step of its System, in substeps, each of which moves
// controls, sums forces, predicts, projects rods, resolves contact and judges links.
//
// All quantities are SI. A step cannot fail; watchdog.h says afterwards whether the motion can be
// gone on from. One thread at a time may use a stepper; it divides its loops among a thread pool of
// its own.
#pragma once

#include "constraints/rod_damping.h"
#include "constraints/rod_solver.h"
#include "contact/fabric_contact.h"
#include "contact/obstacle_motion.h"
#include "forces/forces.h"
#include "parallel/thread_pool.h"
#include "step/accuracy.h"
#include "step/end_loads.h"
#include "step/inputs.h"
#include "step/numerical_damping.h"
#include "step/particle_motion.h"
#include "step/solver_plan.h"
#include "step/step_times.h"
#include "system/system.h"
#include "tearing/tearing.h"

namespace ripstop {

// Looks at the state within a step, and changes nothing. Most look at few of these moments.
class SubstepWatch
{
public:
    virtual ~SubstepWatch() = default;
    virtual void beforeContact(const System&, const State&) {}
    virtual void afterContact(const System&, const State&) {}
    // Contacts that were solved together with rods, before velocities follow.
    //   h      s
    //   reach  s, as RodTask::h, of their pushes
    virtual void afterSolve(std::span<const HeldContact> /*contacts*/, double /*h*/,
                            double /*reach*/)
    {}
    // Tensions of rods that are solved together are those of the substep.
    //   h           s
    //   integrator  that went so far, any but Auto
    virtual void afterSubstep(const System& system, const State& state, double h,
                              Integrator integrator) = 0;
};

// Advances a State by one time step of its System. It holds scratch arrays only: two steppers
// given the same system and state do exactly the same, whatever their number of threads.
class Stepper
{
public:
    explicit Stepper(int threads = 1)
        : m_pool(threads)
    {}

    // Returns the number of substeps that it took.
    int step(const System& system, State& state);

    // Adds what each stage of the steps from now on takes; null stops that.
    void keepTimes(StepTimes* times) { m_clock.giveTo(times); }

    // Cuts each substep, however long it is chosen, in so many from now on.
    void refine(int times) { m_refinement = times; }
    int refinement() const { return m_refinement; }

    // Lets somebody more look at the steps from now on, or nobody.
    void watch(SubstepWatch& watch) { m_watches.push_back(&watch); }
    void stopWatches() { m_watches.clear(); }

    // Which obstacles each particle met in the last step, as touchOf() has it; empty without any.
    std::span<const std::uint32_t> touches() const { return m_touches; }

    // Contacts with obstacles that were solved together with rods in the last substep.
    std::span<const HeldContact> contacts() const { return m_rods.contacts(); }

    // What such a contact pushes and rubs its particle with, N.
    Vec3 forceOf(const HeldContact& contact) const { return contact.push() / (m_reach * m_reach); }

    // Of the last step.
    const StepAccuracy& accuracy() const { return m_accuracy; }
    const NumericalDamping& numericalDamping() const { return m_numericalDamping; }
    Integrator integrator() const { return m_integrator; } // any but Auto

    // Whether lines that get tight may be stopping something, so that BDF2 went by Euler's formula
    // in the last step.
    bool hasSnatch() const { return m_hasSnatch; }

    // By how much more than it holds a line or spar bore that broke in the last step, 1; the most.
    double lateBreak() const { return m_tearing.late; }

    // Of the next step; where the solver chooses and has not yet, the fewest that the author asks
    // for. The first step of a run may be cut finer.
    int substepsOf(const System& system, const State& state) const;

    // Hz, likewise, of its substeps: step/true_swings.h. 0 before the first step.
    double fastestTrueSwing(const System& system, const State& state) const;

    // What Solver::Auto began with and why, once there was a step; empty for other solvers.
    Message choice(const System& system) const
    {
        return m_planFor.isOf(system) && system.solver == Solver::Auto ? m_plan.reason : Message();
    }

private:
    void prepare(const System& system, State& state);
    std::span<const PaddedVec3> startOf(const State& state) const;
    void noteDamping(const System& system, const State& state, double h, double share);
    void substep(RodTask& task, State& state, double h);
    RodTask rodTask(const System& system, State& state, double h) const;
    int chosenSubsteps(const System& system, const State& state) const;
    void adapt(const System& system, State& state, int substeps);
    int substepsForDamping(const System& system, const State& state) const;
    void fillAccelerations(const System& system, const State& state, double h);
    bool dampsImplicitly(const System& system) const;
    bool solvesTogether(const System& system) const; // all rods, as far as they can move
    bool solvesContact(const System& system) const;
    void fillLoads(RodTask& task, const State& state, double h, const SeenVelocities& velocities);
    void correctLoads(RodTask& task, State& state, double h);
    void predict(const System& system, State& state, double h);
    void beginAnew(RodTask& task, State& state, double h);
    bool beginsBdf2(const System& system, const State& state) const;
    void takeMeans(const System& system, State& state, double h);
    bool isSteady(const System& system, const State& state) const;
    void move(ParticlePass pass, const System& system, State& state, double h);
    void noteRodLengths(const System& system, const State& state);
    void project(RodTask& task, State& state, double h);

    ThreadPool m_pool;
    StepClock m_clock;
    std::vector<SubstepWatch*> m_watches;
    RodSolver m_rods;
    RodDamping m_rodDamping;
    SolverPlan m_plan; // of Solver::Auto
    PlanFor m_planFor;
    Integrator m_integrator = Integrator::SemiImplicitEuler; // of this step; any but Auto
    StepAccuracy m_accuracy;
    NumericalDamping m_numericalDamping;
    double m_noted = 0.0;     // 1, of this step, by noteDamping()
    bool m_looksBack = false; // the last substep went by the formula of BDF2
    bool m_hasSnatch = false; // in this step
    PinWays m_pinWays;
    FabricContact m_fabric;
    Forces m_forces;
    std::vector<Lane> m_lanes;              // of the forces that act now
    std::vector<PaddedVec3> m_acceleration; // [particles] m/s^2, of forces, not of rods or contact
    std::vector<PaddedVec3> m_before;       // [particles] m, at the start of the substep
    std::vector<PaddedVec3> m_scratch;      // [particles] of particle_motion.h, or startOf()
    std::vector<PaddedVec3> m_stage[3];     // [particles] of takeMeans(), or empty
    std::vector<PlacedObstacle> m_placed;   // [obstacles] in this substep
    std::vector<std::uint8_t> m_held;       // [particles] of followHeldContacts(), or empty
    std::vector<PaddedVec3> m_came;       // [particles] m/s, at the start of the substep, or empty
    std::vector<std::uint32_t> m_touches; // [particles] in this step, or empty
    std::vector<double> m_restLength;     // [rods] m, with the weight shifts of now
    std::span<const double> m_heldLength; // [rods] m, the same as they are damped
    double m_reach = 0.0;                 // s, of the last substep
    std::vector<double> m_rodLength;      // [rods] m, before projection
    mutable Damping m_damping;            // of forces
    std::vector<PaddedVec3> m_implicit;   // [particles] m/s^2, of withDamping(), or empty
    std::vector<PaddedVec3> m_seen;       // [particles] m/s, by the forces, or empty
    std::vector<PaddedVec3> m_velocityBefore; // [particles] m/s, of the substep before, or empty
    std::vector<PaddedVec3> m_nearby;         // [particles] m, of correctLoads(), or empty
    TearScratch m_tearing;                    // with room for all that may tear
    int m_refinement = 1;
    std::size_t m_tears = 0;    // before this time step
    std::uint64_t m_serial = 0; // of the system that m_restLength is of
    std::uint64_t m_valuesSerial = 0;
    bool m_summed = false;       // accelerations were, in this step
    double m_keep = 1.0;         // share of the speed that viscosity leaves in a substep
    bool m_mayPart = true;       // the mesh, after this substep
    bool m_tearsByForce = false; // some rod does, so tensions are needed in every substep
};

} // namespace ripstop
