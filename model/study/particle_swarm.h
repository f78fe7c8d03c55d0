// Particle swarm (Kennedy and Eberhart 1995): points that fly through the cube of all shares from 0
// to 1, each drawn to the best place that it has been at and to the best of its neighbours.
//
//     v <- chi (v + phi r1 (own - x) + phi r2 (neighbours' - x)),   x <- x + v
//
// with phi = 2.05 and chi = 0.7298, which makes it come to rest (Clerc and Kennedy 2002), and one
// neighbour on either side of a ring, which keeps it from settling on the first good place that is
// seen (Kennedy 1999). At a wall a particle stops. It starts from points of Sobol'.
#pragma once

#include "study/goal.h"
#include "study/random_share.h"

#include <vector>

namespace ripstop {

using SharePlace = std::vector<double>; // [variables] 0 to 1

// Points of Sobol', shifted by the seed; at random beyond its dimensions.
std::vector<SharePlace> firstPlaces(std::size_t variables, std::size_t count, std::uint64_t seed);

class ParticleSwarm
{
public:
    ParticleSwarm(std::size_t variables, std::size_t count, std::uint64_t seed);

    const std::vector<SharePlace>& places() const { return m_place; }
    void move(const std::vector<Score>& scores); // of places(), to the next ones

private:
    std::vector<SharePlace> m_place;
    std::vector<SharePlace> m_velocity;
    std::vector<SharePlace> m_best; // of each particle so far
    std::vector<Score> m_bestScore;
    RandomShares m_random;
};

} // namespace ripstop
