#include "forces/line_drag.h"

#include "forces/wind.h"

#include <cmath>

namespace ripstop {

Vec3 lineDrag(double width, const Vec3& a, const Vec3& b, const Vec3& apparentWind,
              double airDensity)
{
    const Vec3 line = b - a;
    const double square = line.squaredNorm();
    if (square == 0.0)
        return Vec3::Zero();
    const Vec3 across = apparentWind - (apparentWind.dot(line) / square) * line;
    return (0.5 * airDensity * width * std::sqrt(square) * across.norm()) * across;
}

void fillLineDrags(const System& system, const State& state, ThreadPool& pool,
                   std::span<PaddedVec3> drag)
{
    const Vec3 common = commonWind(system, state);
    const bool isLocal = hasLocalWind(system, state);
    pool.parallelFor(system.dragLines.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const DragLine& line = system.dragLines[i];
            if (isTorn(system.links[std::size_t(line.link)], state)) {
                drag[i] = PaddedVec3();
                continue;
            }
            const auto a = std::size_t(line.a);
            const auto b = std::size_t(line.b);
            Vec3 wind = common - 0.5 * (state.velocity[a] + state.velocity[b]);
            if (isLocal)
                wind += localWind(system, state, 0.5 * (state.position[a] + state.position[b]));
            drag[i] =
                lineDrag(line.width, state.position[a], state.position[b], wind, system.airDensity);
        }
    });
}

} // namespace ripstop
