// move() takes what is better into memory first, then moves all, so that the order does not matter.
#include "study/particle_swarm.h"

#include "study/plan.h"

namespace ripstop {
namespace {

constexpr double constriction = 0.7298437881283576;
constexpr double attraction = 2.05;
constexpr std::uint64_t forSwarm = 0x9a57'c1e5; // so that draws are not those of the first places

} // namespace

std::vector<SharePlace> firstPlaces(std::size_t variables, std::size_t count, std::uint64_t seed)
{
    std::vector<SharePlace> places(count, SharePlace(variables));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t v = 0; v < variables; ++v)
            places[i][v] = v < sobolDimensions ? shiftedSobolShare(i, v, seed)
                                               : shareOf(randomBits(seed, i, v));
    return places;
}

ParticleSwarm::ParticleSwarm(std::size_t variables, std::size_t count, std::uint64_t seed)
    : m_place(firstPlaces(variables, count, seed))
    , m_velocity(m_place)
    , m_random(seed ^ forSwarm)
{
    // from anywhere towards anywhere else, by half of the way
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t v = 0; v < variables; ++v)
            m_velocity[i][v] = 0.5 * (m_random.next() - m_place[i][v]);
}

void ParticleSwarm::move(const std::vector<Score>& scores)
{
    const std::size_t count = m_place.size();
    if (m_best.empty()) {
        m_best = m_place;
        m_bestScore = scores;
    }
    for (std::size_t i = 0; i < count; ++i)
        if (dominates(scores[i], m_bestScore[i])) {
            m_best[i] = m_place[i];
            m_bestScore[i] = scores[i];
        }
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t guide = i;
        for (const std::size_t neighbour : {(i + count - 1) % count, (i + 1) % count})
            if (dominates(m_bestScore[neighbour], m_bestScore[guide]))
                guide = neighbour;
        for (std::size_t v = 0; v < m_place[i].size(); ++v) {
            double& x = m_place[i][v];
            double& speed = m_velocity[i][v];
            const double toOwn = attraction * m_random.next() * (m_best[i][v] - x);
            const double toGuide = attraction * m_random.next() * (m_best[guide][v] - x);
            speed = constriction * (speed + toOwn + toGuide);
            x += speed;
            if (x < 0.0 || x > 1.0) {
                x = x < 0.0 ? 0.0 : 1.0;
                speed = 0.0;
            }
        }
    }
}

} // namespace ripstop
