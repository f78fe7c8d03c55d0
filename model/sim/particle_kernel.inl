// What a substep does to each particle, apart from the rods; see particle_motion.h.

RIPSTOP_INLINE void stop(const ParticleMotion& m, std::size_t i) // a pinned particle
{
    four(m.before[i]) = four(m.position[i]);
    four(m.velocity[i]) = four(m.drift[i]) = Four{};
}

// Moves particles to where they would be without rods.
template <Integrator integrator>
RIPSTOP_INLINE void predict(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    const Four h = all(m.h);
    for (std::size_t i = first; i < last; ++i) {
        if (m.inverseMass[i] == 0.0) {
            stop(m, i);
            continue;
        }
        Four x = four(m.position[i]);
        Four v = four(m.velocity[i]);
        const Four a = four(m.acceleration[i]);
        four(m.before[i]) = x;
        if constexpr (integrator == Integrator::ExplicitEuler) {
            x += h * v;
            v += h * a;
        } else if constexpr (integrator == Integrator::SemiImplicitEuler) {
            v += h * a;
            x += h * v;
        } else {
            // x' = 2 x - previous + a h^2, Verlet 1967, with (x - previous) / h remembered instead
            // of the previous position, which would lose digits far from the origin. The start
            // previous = x - v h + a h^2 / 2 keeps it of second order, also after a substep of
            // another length. Velocity Verlet goes the
            // same way; from v at a full step it would count only half of the acceleration of what
            // rods hold.
            Four drift = m.drifts ? four(m.drift[i]) : Four(v - 0.5 * h * a);
            drift += h * a;
            x += h * drift;
            four(m.drift[i]) = drift;
        }
        four(m.position[i]) = x;
        four(m.velocity[i]) = v;
        if constexpr (integrator == Integrator::ExplicitEuler)
            four(m.predicted[i]) = x;
    }
}

RIPSTOP_INLINE bool isZero(Four v) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; }

// Where predict() put a particle: what it did is done once more, since memory costs more.
template <Integrator integrator>
RIPSTOP_INLINE Four predicted(const ParticleMotion& m, std::size_t i)
{
    if constexpr (integrator == Integrator::ExplicitEuler)
        return four(m.predicted[i]);
    else if constexpr (integrator == Integrator::SemiImplicitEuler)
        return four(m.before[i]) + all(m.h) * four(m.velocity[i]);
    else
        return four(m.before[i]) + all(m.h) * four(m.drift[i]);
}

// Velocities take over what the rods did to the positions.
template <Integrator integrator>
RIPSTOP_INLINE void followRods(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    constexpr bool verlet =
        integrator == Integrator::Verlet || integrator == Integrator::VelocityVerlet;
    const Four perStep = all(1.0 / m.h);
    const Four keep = all(m.keep);
    for (std::size_t i = first; i < last; ++i) {
        if (m.inverseMass[i] == 0.0)
            continue;
        const Four correction = four(m.position[i]) - predicted<integrator>(m, i);
        if constexpr (verlet) {
            // The half step of acceleration that turns the drift into the velocity of now is right
            // for free motion only: at rest in a rod it would read as a fall.
            const Four drift = four(m.drift[i]) + correction * perStep;
            Four v = drift;
            if (isZero(correction))
                v += 0.5 * all(m.h) * four(m.acceleration[i]);
            four(m.velocity[i]) = v * keep;
            four(m.drift[i]) = drift * keep;
        } else {
            four(m.velocity[i]) = (four(m.velocity[i]) + correction * perStep) * keep;
        }
    }
}

// Drag and dampers keep velocity Verlet of second order only if they see the velocity of the end
// of the step; for what rods hold, that is the way it went.
template <Integrator integrator>
RIPSTOP_INLINE void foreseeVelocities(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        const Four correction = four(m.position[i]) - predicted<integrator>(m, i);
        four(m.velocity[i]) = four(m.drift[i])
                              + (isZero(correction) ? 0.5 * all(m.h) * four(m.acceleration[i])
                                                    : correction * all(1.0 / m.h));
    }
}

// What bends take off the force on a particle. Kept out of line, as few scenes have it.
__attribute__((noinline)) void takeBending(const System& system, const PaddedVec3* moment,
                                           std::size_t particle, Four& force)
{
    for (int k = system.bendsAt.start[particle]; k < system.bendsAt.start[particle + 1]; ++k) {
        const int item = system.bendsAt.items[std::size_t(k)];
        const Bend& bend = system.bends[std::size_t(item / 4)];
        force -= all(bend.weight[std::size_t(item % 4)]) * four(moment[item / 4]);
    }
}

// Forces are computed per element and gathered per particle in the order of the elements, so that
// sums do not depend on who computed what when.
void gather(const System& system, const ForcesOnElements& forces, PaddedVec3* acceleration,
            std::size_t first, std::size_t last)
{
    const Four gravity = {system.gravity[0], system.gravity[1], system.gravity[2], 0.0};
    const int* const springs = system.springsAt.items.data();
    const int* const panels = system.panelsAt.items.data();
    const int* const lines = system.dragLinesAt.items.data();
    constexpr double signs[2] = {1.0, -1.0};
    const bool drags = !system.dragLines.empty();
    const bool bends = !system.bends.empty();
    for (std::size_t i = first; i < last; ++i) {
        if (system.inverseMass[i] == 0.0) {
            four(acceleration[i]) = Four{};
            continue;
        }
        Four force{};
        for (int k = system.springsAt.start[i]; k < system.springsAt.start[i + 1]; ++k) {
            const double sign = signs[forces.springIsAtB[k]]; // which a branch would guess wrong
            force += all(sign) * four(forces.spring[std::size_t(springs[k])]);
        }
        Four air{};
        for (int k = system.panelsAt.start[i]; k < system.panelsAt.start[i + 1]; ++k)
            air += four(forces.panel[std::size_t(panels[k])]);
        force += air * all(1.0 / 3.0);
        if (drags) {
            Four drag{};
            for (int k = system.dragLinesAt.start[i]; k < system.dragLinesAt.start[i + 1]; ++k)
                drag += four(forces.line[std::size_t(lines[k])]);
            force += drag * all(0.5);
        }
        if (bends) {
            Four left = force; // so that the force itself can stay in a register
            takeBending(system, forces.bend, i, left);
            force = left;
        }
        four(acceleration[i]) = gravity + all(system.inverseMass[i]) * force;
    }
}

template <Integrator integrator>
RIPSTOP_INLINE void runWith(ParticlePass pass, const ParticleMotion& m, std::size_t first,
                            std::size_t last)
{
    if (pass == ParticlePass::Predict)
        predict<integrator>(m, first, last);
    else if (pass == ParticlePass::FollowRods)
        followRods<integrator>(m, first, last);
    else
        foreseeVelocities<integrator>(m, first, last);
}

void run(ParticlePass pass, Integrator integrator, const ParticleMotion& m, std::size_t first,
         std::size_t last)
{
    switch (integrator) {
    case Integrator::ExplicitEuler:
        return runWith<Integrator::ExplicitEuler>(pass, m, first, last);
    case Integrator::SemiImplicitEuler:
        return runWith<Integrator::SemiImplicitEuler>(pass, m, first, last);
    case Integrator::Verlet:
        return runWith<Integrator::Verlet>(pass, m, first, last);
    case Integrator::VelocityVerlet:
        return runWith<Integrator::VelocityVerlet>(pass, m, first, last);
    }
}
