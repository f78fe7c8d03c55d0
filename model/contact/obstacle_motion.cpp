#include "contact/obstacle_motion.h"

#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

Vec3 placeOnPath(const std::vector<PathKey>& path, double time)
{
    const auto next = std::upper_bound(path.begin(), path.end(), time,
                                       [](double t, const PathKey& key) { return t < key.time; });
    if (next == path.begin())
        return path.front().place;
    const PathKey& last = *(next - 1);
    if (next == path.end())
        return last.place;
    const double share = (time - last.time) / (next->time - last.time);
    return last.place + share * (next->place - last.place);
}

struct Box
{
    Vec3 low;
    Vec3 high;
};

// Around the shape in its own frame, without its margin.
Box ownBounds(const Obstacle& obstacle)
{
    switch (obstacle.shape) {
    case ColliderShape::Sphere:
        return {Vec3::Constant(-obstacle.radius), Vec3::Constant(obstacle.radius)};
    case ColliderShape::Box:
        return {-0.5 * obstacle.size, 0.5 * obstacle.size};
    case ColliderShape::HeightField: {
        const Vec3 half(0.5 * obstacle.size.x(), 0.0, 0.5 * obstacle.size.z());
        return {-half, half + Vec3(0.0, obstacle.size.y(), 0.0)};
    }
    case ColliderShape::Mesh:
        if (obstacle.mesh)
            return {obstacle.scale * obstacle.mesh->low(), obstacle.scale * obstacle.mesh->high()};
        break;
    case ColliderShape::Plane:
        break;
    }
    constexpr double all = std::numeric_limits<double>::infinity();
    return {Vec3::Constant(-all), Vec3::Constant(all)};
}

// What touches is within the margin, and a mesh has some always (see touchMesh); a thousandth of
// the size more covers both and all rounding.
void findBounds(const Obstacle& obstacle, PlacedObstacle& placed)
{
    const Box own = ownBounds(obstacle);
    if (obstacle.shape == ColliderShape::Plane) {
        placed.low = own.low;
        placed.high = own.high;
        return;
    }
    const bool turns = obstacle.shape != ColliderShape::Sphere;
    const Vec3 middle = 0.5 * (own.low + own.high), half = 0.5 * (own.high - own.low);
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
        findBounds(system.obstacles[i], placed[i]);
    }
}

} // namespace ripstop
