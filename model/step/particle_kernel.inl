// What a substep does to each particle, apart from the rods; see particle_motion.h.

RIPSTOP_INLINE void stop(const ParticleMotion& m, std::size_t i) // a pinned particle
{
    pack(m.before[i]) = pack(m.position[i]);
    pack(m.velocity[i]) = pack(m.drift[i]) = pack(m.velocityBefore[i]) = Pack{};
}

// Forces are at the end of the substep, as far as the last two tell where that is. Places are told
// to first order alone, which what oscillates on a stiff spring stays stable by. Velocities are
// those of now where what forces take from them joins the masses and so is of the end in any case:
// what a particle's neighbours do to its load does not join, and each substep would add to their
// change what the last one did, until a light sail flutters in a steady wind.
RIPSTOP_INLINE void foresee(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    const Pack h = all(m.h);
    for (std::size_t i = first; i < last; ++i) {
        const Pack x = pack(m.position[i]);
        const Pack v = pack(m.velocity[i]);
        pack(m.before[i]) = x;
        pack(m.scratch[i]) = v;
        if (m.inverseMass[i] == 0.0 || !m.drifts)
            continue;
        pack(m.position[i]) = x + h * v;
        if (!m.damps)
            pack(m.velocity[i]) = 2.0 * v - pack(m.velocityBefore[i]);
    }
}

// Moves particles to where they would be without rods.
template <Integrator integrator>
RIPSTOP_INLINE void predict(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    const Pack h = all(m.h);
    for (std::size_t i = first; i < last; ++i) {
        if (m.inverseMass[i] == 0.0) {
            stop(m, i);
            continue;
        }
        constexpr bool foreseen = integrator == Integrator::Bdf2;
        Pack x = foreseen ? pack(m.before[i]) : pack(m.position[i]);
        Pack v = foreseen ? pack(m.scratch[i]) : pack(m.velocity[i]);
        const Pack a = pack(m.acceleration[i]);
        pack(m.before[i]) = x;
        if constexpr (integrator == Integrator::ExplicitEuler) {
            x += h * v;
            v += h * a;
        } else if constexpr (integrator == Integrator::SemiImplicitEuler) {
            v += h * a;
            x += h * v;
        } else if constexpr (integrator == Integrator::RungeKutta4) {
            v += h * a; // the means that Stepper::takeMeans() has found
            x += h * pack(m.scratch[i]);
        } else if constexpr (integrator == Integrator::Bdf2) {
            // 3 v' - 4 v + v'' = 2 h a and 3 x' - 4 x + x'' = 2 h v', which rods then go on with:
            // their pulls are those of the end of the substep. The first is one of implicit Euler.
            const Pack now = v;
            if (m.drifts) {
                v = (4.0 * v - pack(m.velocityBefore[i])) * all(1.0 / 3.0) + all(m.reach) * a;
                x += h * all(1.0 / 3.0) * pack(m.drift[i]) + all(m.reach) * v;
            } else {
                v += h * a;
                x += h * v;
            }
            pack(m.velocityBefore[i]) = now;
            pack(m.scratch[i]) = x;
        } else {
            // x' = 2 x - previous + a h^2, Verlet 1967, with (x - previous) / h remembered instead
            // of the previous position, which would lose digits far from the origin. The start
            // previous = x - v h + a h^2 / 2 keeps it of second order, also after a substep of
            // another length. Velocity Verlet goes the
            // same way; from v at a full step it would count only half of the acceleration of what
            // rods hold.
            Pack drift = m.drifts ? pack(m.drift[i]) : Pack(v - 0.5 * h * a);
            drift += h * a;
            x += h * drift;
            pack(m.drift[i]) = drift;
        }
        pack(m.position[i]) = x;
        pack(m.velocity[i]) = v;
        if constexpr (integrator == Integrator::ExplicitEuler)
            pack(m.scratch[i]) = x;
    }
}

// From where predict() began, as its first substep goes.
RIPSTOP_INLINE void predictAnew(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    const Pack h = all(m.h);
    for (std::size_t i = first; i < last; ++i) {
        if (m.inverseMass[i] == 0.0)
            continue;
        const Pack v = pack(m.velocityBefore[i]) + h * pack(m.acceleration[i]);
        const Pack x = pack(m.before[i]) + h * v;
        pack(m.velocity[i]) = v;
        pack(m.position[i]) = pack(m.scratch[i]) = x;
    }
}

RIPSTOP_INLINE bool isZero(Pack v) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; }

// Where predict() put a particle: what it did is done once more, since memory costs more.
template <Integrator integrator>
RIPSTOP_INLINE Pack predicted(const ParticleMotion& m, std::size_t i)
{
    if constexpr (integrator == Integrator::ExplicitEuler || integrator == Integrator::Bdf2)
        return pack(m.scratch[i]);
    else if constexpr (integrator == Integrator::RungeKutta4)
        return pack(m.before[i]) + all(m.h) * pack(m.scratch[i]);
    else if constexpr (integrator == Integrator::SemiImplicitEuler)
        return pack(m.before[i]) + all(m.h) * pack(m.velocity[i]);
    else
        return pack(m.before[i]) + all(m.h) * pack(m.drift[i]);
}

// Velocities take over what the rods did to the positions.
template <Integrator integrator>
RIPSTOP_INLINE void followRods(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    const Pack perStep = all(1.0 / m.reach);
    const Pack keep = all(m.keep);
    for (std::size_t i = first; i < last; ++i) {
        if (m.inverseMass[i] == 0.0)
            continue;
        const Pack correction = pack(m.position[i]) - predicted<integrator>(m, i);
        if constexpr (isVerlet(integrator)) {
            // The half step of acceleration that turns the drift into the velocity of now is right
            // for free motion only: at rest in a rod it would read as a fall.
            const Pack drift = pack(m.drift[i]) + correction * perStep;
            Pack v = drift;
            if (isZero(correction))
                v += 0.5 * all(m.h) * pack(m.acceleration[i]);
            pack(m.velocity[i]) = v * keep;
            pack(m.drift[i]) = drift * keep;
        } else if constexpr (integrator == Integrator::Bdf2) {
            const Pack v = pack(m.velocity[i]) + correction * perStep;
            const Pack drift =
                m.drifts ? Pack(all(1.0 / 3.0) * pack(m.drift[i]) + all(2.0 / 3.0) * v) : v;
            pack(m.velocity[i]) = pack(m.scratch[i]) = v * keep;
            pack(m.drift[i]) = drift * keep;
            pack(m.velocityBefore[i]) *= keep;
        } else {
            pack(m.velocity[i]) = (pack(m.velocity[i]) + correction * perStep) * keep;
        }
    }
}

// As if the particle had always come the way that contact has sent it.
RIPSTOP_INLINE void followContact(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        const Pack change = pack(m.velocity[i]) - pack(m.scratch[i]);
        if (m.inverseMass[i] == 0.0 || isZero(change))
            continue;
        pack(m.drift[i]) += change;
        pack(m.velocityBefore[i]) += change;
    }
}

// Drag and dampers keep velocity Verlet of second order only if they see the velocity of the end
// of the step; for what rods hold, that is the way it went.
template <Integrator integrator>
RIPSTOP_INLINE void foreseeVelocities(const ParticleMotion& m, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        if (m.inverseMass[i] == 0.0)
            continue;
        const Pack correction = pack(m.position[i]) - predicted<integrator>(m, i);
        pack(m.velocity[i]) = pack(m.drift[i])
                              + (isZero(correction) ? 0.5 * all(m.h) * pack(m.acceleration[i])
                                                    : correction * all(1.0 / m.h));
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
    else if (pass == ParticlePass::Foresee)
        foresee(m, first, last);
    else if (pass == ParticlePass::PredictAnew)
        predictAnew(m, first, last);
    else if (pass == ParticlePass::FollowContact)
        followContact(m, first, last);
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
    case Integrator::ImplicitEuler: // what is implicit about it, the global solve does
        return runWith<Integrator::SemiImplicitEuler>(pass, m, first, last);
    case Integrator::Verlet:
        return runWith<Integrator::Verlet>(pass, m, first, last);
    case Integrator::VelocityVerlet:
        return runWith<Integrator::VelocityVerlet>(pass, m, first, last);
    case Integrator::Bdf2:
        return runWith<Integrator::Bdf2>(pass, m, first, last);
    case Integrator::RungeKutta4:
        return runWith<Integrator::RungeKutta4>(pass, m, first, last);
    case Integrator::Auto: // the stepper has made its choice
        break;
    }
}
