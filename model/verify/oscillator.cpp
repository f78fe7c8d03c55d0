#include "verify/oscillator.h"

#include "assembly/finish.h"

namespace ripstop {

Integrator integratorOf(Scheme scheme)
{
    switch (scheme) {
    case Scheme::ExplicitEuler:
        return Integrator::ExplicitEuler;
    case Scheme::SemiImplicitEuler:
        return Integrator::SemiImplicitEuler;
    case Scheme::Verlet:
    case Scheme::NaiveVerlet:
        return Integrator::Verlet;
    case Scheme::VelocityVerlet:
        return Integrator::VelocityVerlet;
    case Scheme::RungeKutta4:
        break;
    }
    return Integrator::RungeKutta4;
}

std::string nameOf(Scheme scheme)
{
    return nameOf(integratorOf(scheme)) + (scheme == Scheme::NaiveVerlet ? " (naive start)" : "");
}

System oscillator(Scheme scheme, double timeStep, double frequency, double damping,
                  const Vec3& anchor)
{
    System system = emptySystem(timeStep, integratorOf(scheme));
    addPin(system, anchor);
    addParticle(system, anchor + Vec3(1.0, 0.0, 0.0), 1.0);
    addSpring(system, 0, 1, 0.0, frequency * frequency, damping);
    finish(system);
    if (scheme == Scheme::NaiveVerlet) {
        system.start.driftSubstep = system.timeStep / system.substeps;
        system.start.drift = system.start.velocity;
    }
    return system;
}

OscillatorTrace follow(const System& system, int steps)
{
    OscillatorTrace motion;
    Stepper stepper;
    State state = system.start;
    const bool verlet = system.integrator == Integrator::Verlet;
    for (int i = 0; i <= steps; ++i) {
        motion.x.push_back(state.position[1].x());
        const double drift = state.drift[1].x();
        motion.v.push_back(state.velocity[1].x());
        stepper.step(system, state);
        if (verlet && i > 0)
            motion.v.back() = 0.5 * (drift + state.drift[1].x());
    }
    return motion;
}

} // namespace ripstop
