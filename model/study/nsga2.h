// NSGA-II (Deb, Pratap, Agarwal and Meyarivan 2002): a population that spreads along the Pareto
// front, for several objectives.
//
// Parents are chosen by tournaments, first by rank, then by how lonely they are; children come of
// two of them by simulated binary crossover (Deb and Agrawal 1995), with probability 0.9 and
// distribution index 15, and polynomial mutation (Deb and Goyal 1996), of one variable in the mean
// and with index 20. The better half of parents and children lives on. It starts from points of
// Sobol'.
#pragma once

#include "study/particle_swarm.h"

namespace ripstop {

// The rank of each: 0 is dominated by none, 1 by those of rank 0 alone, and so on.
std::vector<std::size_t> paretoRanks(const std::vector<Score>& scores);

// How far the neighbours of each of these, which have one rank, are apart, in sum over the
// objectives; infinite at the ends.
std::vector<double> crowdingDistances(const std::vector<Score>& scores,
                                      const std::vector<std::size_t>& members);

class Nsga2
{
public:
    //   count  at least 2
    Nsga2(std::size_t variables, std::size_t count, std::uint64_t seed);

    const std::vector<SharePlace>& places() const { return m_children; }
    void move(const std::vector<Score>& scores); // of places(), to the next ones

private:
    std::vector<std::size_t> select(std::size_t count);
    std::size_t parent();
    void breed();

    std::vector<SharePlace> m_place; // of the population
    std::vector<Score> m_score;
    std::vector<std::size_t> m_rank;
    std::vector<double> m_distance;
    std::vector<SharePlace> m_children;
    RandomShares m_random;
};

} // namespace ripstop
