#include "recording/compare_runs.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace ripstop {
namespace {

// Where the particles of one network stand in another.
class Pairs
{
public:
    void match(const Frame& a, const Frame& b)
    {
        if (m_a == a.layout && m_b == b.layout)
            return;
        m_a = a.layout;
        m_b = b.layout;
        std::unordered_map<std::uint32_t, std::size_t> places;
        for (std::size_t i = 0; i < b.layout->particleId.size(); ++i)
            places.emplace(b.layout->keyOf(i), i);
        m_pairs.clear();
        for (std::size_t i = 0; i < a.layout->particleId.size(); ++i)
            if (const auto found = places.find(a.layout->keyOf(i)); found != places.end())
                m_pairs.emplace_back(i, found->second);
    }

    RunDistance distance(const Frame& a, const Frame& b) const
    {
        RunDistance result{.time = a.time, .particles = m_pairs.size()};
        const double later = a.time - b.time;
        double squares = 0.0;
        for (const auto& [i, j] : m_pairs) {
            const double distance = (a.position[i] - b.position[j] - later * b.velocity[j]).norm();
            squares += distance * distance;
            if (distance > result.most) {
                result.most = distance;
                result.farthest = a.layout->particleId[i];
            }
        }
        if (!m_pairs.empty())
            result.rms = std::sqrt(squares / double(m_pairs.size()));
        return result;
    }

private:
    std::shared_ptr<const Layout> m_a;
    std::shared_ptr<const Layout> m_b;
    std::vector<std::pair<std::size_t, std::size_t>> m_pairs;
};

} // namespace

RunDistance distanceOf(const Frame& a, const Frame& b)
{
    Pairs pairs;
    pairs.match(a, b);
    return pairs.distance(a, b);
}

Result<std::vector<RunDistance>> compareRuns(const Recording& a, const Recording& b,
                                             double interval, const Progress& progress)
{
    std::vector<RunDistance> list;
    if (a.frameCount() == 0 || b.frameCount() == 0)
        return Failure{"One of the recordings holds no frame."};
    const double from = std::max(a.timeOf(0), b.timeOf(0));
    const double to = std::min(a.timeOf(a.frameCount() - 1), b.timeOf(b.frameCount() - 1));
    const double roundOff = 1e-9; // s
    if (to < from - roundOff)
        return Failure{"The recordings have no time in common."};
    Pairs pairs;
    const std::size_t last = a.frameAt(to);
    for (std::size_t i = a.frameAt(from); i <= last; ++i) {
        const double time = a.timeOf(i);
        const bool isDue =
            list.empty() || i == last || time - list.back().time > interval - roundOff;
        if (!isDue || time < from - roundOff || time > to + roundOff)
            continue;
        const auto one = a.frame(i);
        const auto other = b.frame(b.frameAt(time));
        if (!one || !other)
            return one ? other.failure() : one.failure();
        pairs.match(**one, **other);
        list.push_back(pairs.distance(**one, **other));
        if (!goesOn(progress, double(i + 1) / double(last + 1)))
            return Failure{"Cancelled."};
    }
    return list;
}

} // namespace ripstop
