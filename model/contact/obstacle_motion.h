// Where obstacles are: their own place or their path, and what inputs and hands add.
//
// Contact needs the place of an obstacle at the end of a substep, the way that it went in it, and
// bounds of all that it may touch on that way. The stepper calls beginMoves() before inputs and
// carried colliders move, and endMoves() after them. obstaclePosition() changes nothing; frames
// ask it too.
#pragma once

#include "system/system.h"

#include <span>

namespace ripstop {

// An obstacle in one substep.
struct PlacedObstacle
{
    Vec3 position = Vec3::Zero(); // m, at the end of the substep
    Vec3 way = Vec3::Zero();      // m, that it went in the substep
    Vec3 low = Vec3::Zero();      // m; all that it touches on its way lies between low and high
    Vec3 high = Vec3::Zero();
    Solid solid; // in its own frame
};

// Position of an obstacle, m, at `time` with the inputs as they are in `state`.
Vec3 obstaclePosition(const System& system, const State& state, std::size_t obstacle, double time);

// beginMoves() notes the positions at the start of a substep, before the inputs move; endMoves()
// fills in all else at its end.
//   time    s, of the start or the end
//   placed  [obstacles]
void beginMoves(const System& system, const State& state, double time,
                std::span<PlacedObstacle> placed);
void endMoves(const System& system, const State& state, double time,
              std::span<PlacedObstacle> placed);

} // namespace ripstop
