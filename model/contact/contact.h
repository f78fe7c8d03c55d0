// Contact of particles with obstacles, whichever shape they have (shapes/solid.h).
//
// A particle that is inside, or that went through on its way, is put back on the surface of the
// side that it came from; the responses differ in what is left of its velocity, which is that
// relative to the obstacle when the obstacle moves:
//     stop     nothing
//     slide    all but the part that goes inwards
//     contact  the inward part comes back times the restitution, and Coulomb friction takes from
//              the rest up to friction x (normal impulse)
// The way is that of the substep, so nothing tunnels at any speed. Only particles touch: a collider
// that is narrower than the panels may fit between them.
#pragma once

#include "contact/obstacle_motion.h"
#include "parallel/thread_pool.h"
#include "system/system.h"

#include <cstdint>
#include <span>

namespace ripstop {

// Resolves the contacts of one substep, in parallel over the particles: changes position, velocity
// and drift of those that touch. `h` is the substep, s: an impact that is slower than what gravity
// adds in two substeps counts as rest and does not bounce.
//   before  [particles]  m, position at the start of the substep
//   placed  [obstacles]  after endMoves()
//   touches [particles]  adds touchOf() of each obstacle that was met
//   held    [particles]  1 where the solver of the rods has done all that (surface_search.h)
void resolveContacts(const System& system, State& state, std::span<const PaddedVec3> before,
                     std::span<const PlacedObstacle> placed, double h, ThreadPool& pool,
                     std::span<std::uint32_t> touches, std::span<const std::uint8_t> held = {});

// The bit of an obstacle in `touches`: one for each of the first 32, 0 for those after them.
constexpr std::uint32_t touchOf(std::size_t obstacle)
{
    return obstacle < 32 ? std::uint32_t(1) << obstacle : 0;
}

} // namespace ripstop
