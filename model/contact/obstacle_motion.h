// Where obstacles are: their own place or their path, and what inputs and hands add.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// An obstacle in one substep.
struct PlacedObstacle
{
    Vec3 position = Vec3::Zero(); // m, at its end
    Vec3 way = Vec3::Zero();      // m, that it went
    Vec3 low = Vec3::Zero();      // m, what it touches lies between these all the time
    Vec3 high = Vec3::Zero();
    Solid solid; // in its own frame
};

// Position of an obstacle, m, at `time` with the inputs as they are in `state`.
Vec3 obstaclePosition(const System& system, const State& state, std::size_t obstacle, double time);

// Positions at the start of a substep, before the inputs move, and what follows at its end.
void beginMoves(const System& system, const State& state, double time,
                std::span<PlacedObstacle> placed);
void endMoves(const System& system, const State& state, double time,
              std::span<PlacedObstacle> placed);

} // namespace ripstop
