#include "sim/spring_force.h"

#include <algorithm>

namespace ripstop {

double springTension(const Spring& spring, const Vec3& separation, const Vec3& velocityDifference)
{
    const double length = separation.norm();
    if (length == 0.0)
        return 0.0;
    const double stretch = length - spring.restLength;
    const double stretchRate = velocityDifference.dot(separation) / length;
    const double tension = spring.stiffness * stretch + spring.damping * stretchRate;
    switch (spring.resists) {
    case Resists::Tension:
        return stretch > 0.0 ? std::max(tension, 0.0) : 0.0;
    case Resists::Compression:
        return stretch < 0.0 ? std::min(tension, 0.0) : 0.0;
    case Resists::Both:
        break;
    }
    return tension;
}

void fillSpringForces(const System& system, const State& state, Crew& crew,
                      std::span<PaddedVec3> force)
{
    crew.each(system.springs.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Spring& spring = system.springs[i];
            const auto a = std::size_t(spring.a);
            const auto b = std::size_t(spring.b);
            const Vec3 separation = state.position[b] - state.position[a];
            const double length = separation.norm();
            if (state.springTorn[i] || length == 0.0) {
                force[i].setZero();
                continue;
            }
            const double tension =
                springTension(spring, separation, state.velocity[b] - state.velocity[a]);
            force[i] = (tension / length) * separation;
        }
    });
}

} // namespace ripstop
