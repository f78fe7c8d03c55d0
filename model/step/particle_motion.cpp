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

} // namespace ripstop
