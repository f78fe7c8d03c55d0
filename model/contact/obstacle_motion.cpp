#include "contact/obstacle_motion.h"

#include "shapes/place_on_path.h"

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

// Fills in the bounds. What touches is within the margin, and a mesh always has some (see
// touchMesh); a thousandth of the size more covers both and all rounding. A shape without end may
// be met everywhere.
void findBounds(const Obstacle& obstacle, PlacedObstacle& placed)
{
    const ShapeRow& row = rowOf(obstacle.shape);
    const Eigen::AlignedBox3d own = row.bounds(placed.solid);
    if (own.isEmpty()) {
        constexpr double all = std::numeric_limits<double>::infinity();
        placed.low = Vec3::Constant(-all);
        placed.high = Vec3::Constant(all);
        return;
    }
    const bool turns = row.uses.turn;
    const Vec3 middle = 0.5 * (own.min() + own.max()), half = 0.5 * (own.max() - own.min());
    const Vec3 centre = placed.position + (turns ? Vec3(obstacle.turn * middle) : middle);
    const Vec3 reach = (turns ? Vec3(obstacle.turn.cwiseAbs() * half) : half)
                       + Vec3::Constant(obstacle.thickness + 1e-3 * half.norm());
    placed.low = centre - reach - placed.way.cwiseMax(0.0);
    placed.high = centre + reach - placed.way.cwiseMin(0.0);
}

} // namespace

Vec3 obstaclePosition(const System& system, const State& state, std::size_t index, double time)
{
    const Obstacle& obstacle = system.obstacles[index];
    Vec3 position = obstacle.path.empty() ? obstacle.position : placeOnPath(obstacle.path, time);
    for (std::size_t i = 0; i < system.inputs.size(); ++i) {
        const Input& input = system.inputs[i];
        if (input.kind == ControlKind::Move
            && std::find(input.obstacles.begin(), input.obstacles.end(), int(index))
                   != input.obstacles.end())
            position += state.inputValue[i] * input.axis;
    }
    for (std::size_t i = 0; i < state.carried.size(); ++i)
        if (state.hands.carries[i].collider == obstacle.key)
            position += state.carried[i];
    return position;
}

void beginMoves(const System& system, const State& state, double time,
                std::span<PlacedObstacle> placed)
{
    for (std::size_t i = 0; i < placed.size(); ++i)
        placed[i].position = obstaclePosition(system, state, i, time);
}

void endMoves(const System& system, const State& state, double time,
              std::span<PlacedObstacle> placed)
{
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Vec3 position = obstaclePosition(system, state, i, time);
        placed[i].way = position - placed[i].position;
        placed[i].position = position;
        placed[i].solid = solidOf(system.obstacles[i]);
        findBounds(system.obstacles[i], placed[i]);
    }
}

} // namespace ripstop
