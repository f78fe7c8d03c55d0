#include "step/particle_motion.h"

#define RIPSTOP_KERNEL "step/particle_kernel.inl"
#include "parallel/for_each_machine.inl"

namespace ripstop {

double reachOf(Integrator integrator, double h, bool drifts)
{
    return integrator == Integrator::Bdf2 && drifts ? 2.0 / 3.0 * h : h;
}

void runPass(ParticlePass pass, Integrator integrator, const ParticleMotion& motion,
             std::size_t first, std::size_t last)
{
    (wideMachine ? wide::run : anywhere::run)(pass, integrator, motion, first, last);
}

void lookBackAsFar(State& state, double h, ThreadPool& pool)
{
    const double share = h / state.driftSubstep;
    pool.parallelFor(state.position.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec3 now = state.velocity[i];
            state.velocityBefore[i] = Vec3(now + share * (state.velocityBefore[i] - now));
            state.drift[i] = Vec3(now + share * (state.drift[i] - now));
        }
    });
    state.driftSubstep = h;
}

} // namespace ripstop
