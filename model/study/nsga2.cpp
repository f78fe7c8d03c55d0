// move() puts children and parents together, keeps the better half, and breeds the next children.
#include "study/nsga2.h"

#include "base/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop {
namespace {

constexpr double crossoverProbability = 0.9;
constexpr double crossoverIndex = 15.0;
constexpr double mutationIndex = 20.0;
constexpr std::uint64_t forBreeding = 0x2be3'd109;

double power(double base, double exponent) { return portableExp(exponent * portableLog(base)); }

// How far two children lie from the middle of their parents, in halves of what parts those.
double spreadFactor(double share)
{
    const double exponent = 1.0 / (crossoverIndex + 1.0);
    return share <= 0.5 ? power(2.0 * share, exponent)
                        : power(1.0 / (2.0 * (1.0 - share)), exponent);
}

double mutationStep(double share)
{
    const double exponent = 1.0 / (mutationIndex + 1.0);
    return share < 0.5 ? power(2.0 * share, exponent) - 1.0
                       : 1.0 - power(2.0 * (1.0 - share), exponent);
}

} // namespace

std::vector<std::size_t> paretoRanks(const std::vector<Score>& scores)
{
    const std::size_t count = scores.size();
    std::vector<std::size_t> rank(count, 0);
    std::vector<std::size_t> dominators(count, 0);
    std::vector<std::vector<std::size_t>> dominated(count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < count; ++k)
            if (dominates(scores[i], scores[k])) {
                dominated[i].push_back(k);
                ++dominators[k];
            }
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < count; ++i)
        if (dominators[i] == 0)
            front.push_back(i);
    for (std::size_t level = 1; !front.empty(); ++level) {
        std::vector<std::size_t> next;
        for (const std::size_t i : front)
            for (const std::size_t k : dominated[i])
                if (--dominators[k] == 0) {
                    rank[k] = level;
                    next.push_back(k);
                }
        std::ranges::sort(next);
        front = std::move(next);
    }
    return rank;
}

std::vector<double> crowdingDistances(const std::vector<Score>& scores,
                                      const std::vector<std::size_t>& members)
{
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> distance(members.size(), 0.0);
    const std::size_t objectives = members.empty() ? 0 : scores[members.front()].objective.size();
    std::vector<std::size_t> order(members.size());
    for (std::size_t o = 0; o < objectives; ++o) {
        const auto value = [&](std::size_t i) { return scores[members[i]].objective[o]; };
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::ranges::stable_sort(order, {}, value);
        const double size = value(order.back()) - value(order.front());
        distance[order.front()] = distance[order.back()] = infinity;
        if (!(size > 0.0 && std::isfinite(size)))
            continue;
        for (std::size_t i = 1; i + 1 < order.size(); ++i)
            distance[order[i]] += (value(order[i + 1]) - value(order[i - 1])) / size;
    }
    return distance;
}

Nsga2::Nsga2(std::size_t variables, std::size_t count, std::uint64_t seed)
    : m_children(firstPlaces(variables, std::max<std::size_t>(2, count), seed))
    , m_random(seed ^ forBreeding)
{}

// The best of the population by rank, then by loneliness; sets both.
std::vector<std::size_t> Nsga2::select(std::size_t count)
{
    m_rank = paretoRanks(m_score);
    m_distance.assign(m_score.size(), 0.0);
    const std::size_t last = *std::ranges::max_element(m_rank);
    for (std::size_t level = 0; level <= last; ++level) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < m_rank.size(); ++i)
            if (m_rank[i] == level)
                members.push_back(i);
        const std::vector<double> distances = crowdingDistances(m_score, members);
        for (std::size_t i = 0; i < members.size(); ++i)
            m_distance[members[i]] = distances[i];
    }
    std::vector<std::size_t> order(m_score.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return m_rank[a] != m_rank[b] ? m_rank[a] < m_rank[b] : m_distance[a] > m_distance[b];
    });
    order.resize(std::min(count, order.size()));
    return order;
}

std::size_t Nsga2::parent()
{
    const std::size_t one = m_random.below(m_place.size());
    const std::size_t other = m_random.below(m_place.size());
    if (m_rank[one] != m_rank[other])
        return m_rank[one] < m_rank[other] ? one : other;
    return m_distance[one] >= m_distance[other] ? one : other;
}

void Nsga2::breed()
{
    const std::size_t count = m_children.size();
    const std::size_t variables = m_children.front().size();
    m_children.clear();
    while (m_children.size() < count) {
        SharePlace one = m_place[parent()];
        SharePlace other = m_place[parent()];
        if (m_random.next() < crossoverProbability)
            for (std::size_t v = 0; v < variables; ++v) {
                const double factor = spreadFactor(m_random.next());
                const bool isCrossed = m_random.next() < 0.5;
                const double middle = 0.5 * (one[v] + other[v]);
                const double half = 0.5 * factor * (other[v] - one[v]);
                if (isCrossed) {
                    one[v] = middle - half;
                    other[v] = middle + half;
                }
            }
        for (SharePlace* child : {&one, &other})
            for (double& x : *child) {
                if (m_random.next() * double(variables) < 1.0)
                    x += mutationStep(m_random.next());
                x = std::clamp(x, 0.0, 1.0);
            }
        m_children.push_back(std::move(one));
        if (m_children.size() < count)
            m_children.push_back(std::move(other));
    }
}

void Nsga2::move(const std::vector<Score>& scores)
{
    m_place.insert(m_place.end(), m_children.begin(), m_children.end());
    m_score.insert(m_score.end(), scores.begin(), scores.end());
    std::vector<SharePlace> place;
    std::vector<Score> score;
    std::vector<std::size_t> rank;
    std::vector<double> distance;
    for (const std::size_t i : select(m_children.size())) {
        place.push_back(std::move(m_place[i]));
        score.push_back(std::move(m_score[i]));
        rank.push_back(m_rank[i]);
        distance.push_back(m_distance[i]);
    }
    m_place = std::move(place);
    m_score = std::move(score);
    m_rank = std::move(rank);
    m_distance = std::move(distance);
    breed();
}

} // namespace ripstop
