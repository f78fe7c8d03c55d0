#include "contact/start_depth.h"

#include "contact/obstacle_motion.h"
#include "shapes/way_out.h"

#include <algorithm>

namespace ripstop {
namespace {

double depthIn(const Obstacle& obstacle, const Vec3& position, const Vec3& place)
{
    const Vec3 away = place - position;
    const Vec3 own =
        rowOf(obstacle.shape).uses.turn ? Vec3(obstacle.turn.transpose() * away) : away;
    const auto touch = wayOut(obstacle.shape, solidOf(obstacle), own);
    return touch ? (touch->surface - own).norm() : 0.0;
}

} // namespace

StartDepth startDepth(const System& system)
{
    const State& start = system.start;
    StartDepth found;
    std::vector<std::uint8_t> isInside(start.position.size());
    for (std::size_t o = 0; o < system.obstacles.size(); ++o) {
        const Vec3 position = obstaclePosition(system, start, o, start.time);
        for (std::size_t i = 0; i < isInside.size(); ++i) {
            if (system.inverseMass[i] == 0.0)
                continue;
            const double depth = depthIn(system.obstacles[o], position, start.position[i]);
            isInside[i] |= depth > 0.0;
            found.deepest = std::max(found.deepest, depth);
        }
    }
    found.particles = int(std::ranges::count(isInside, 1));
    return found;
}

} // namespace ripstop
