// A level has a step for each variable. Boxes of one level lie between neighbouring places of it;
// the places of the next finer level in such a box are its corners and middles.
#include "study/frontier_search.h"

#include "study/plan.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace ripstop {
namespace {

constexpr std::size_t coarseBoxes = 4; // along each variable, at least, where it has the values

// Places along one variable at this step, the last value included.
std::vector<std::size_t> ticksOf(std::size_t values, std::size_t step)
{
    std::vector<std::size_t> ticks;
    for (std::size_t i = 0; i + 1 < values; i += step)
        ticks.push_back(i);
    ticks.push_back(values - 1);
    return ticks;
}

// Calls `visit` with each combination of one number of each list.
template <typename Visit>
void forEachCombination(const std::vector<std::vector<std::size_t>>& lists, const Visit& visit)
{
    GridPlace place(lists.size(), 0);
    GridPlace number(lists.size(), 0);
    for (;;) {
        for (std::size_t v = 0; v < lists.size(); ++v)
            place[v] = lists[v][number[v]];
        visit(place);
        std::size_t v = lists.size();
        while (v-- > 0) {
            if (++number[v] < lists[v].size())
                break;
            number[v] = 0;
            if (v == 0)
                return;
        }
    }
}

class Search
{
public:
    Search(const Study& study, const HeldAt& heldAt)
        : m_study(study)
        , m_heldAt(heldAt)
    {
        for (const StudyVariable& variable : study.variables) {
            m_values.push_back(variable.values.size());
            std::size_t step = 1;
            while (2 * step * coarseBoxes <= variable.values.size() - 1)
                step *= 2;
            m_coarse.push_back(step);
        }
    }

    std::vector<std::size_t> next() const
    {
        std::size_t level = *std::ranges::max_element(m_coarse);
        if (auto points = unknownOf(ticksAt(level)); !points.empty())
            return points;
        for (; level > 1; level /= 2)
            if (auto points = unknownOfMixed(level); !points.empty())
                return points;
        return {};
    }

private:
    std::size_t stepOf(std::size_t variable, std::size_t level) const
    {
        return std::min(m_coarse[variable], level);
    }

    std::vector<std::vector<std::size_t>> ticksAt(std::size_t level) const
    {
        std::vector<std::vector<std::size_t>> ticks;
        for (std::size_t v = 0; v < m_values.size(); ++v)
            ticks.push_back(ticksOf(m_values[v], stepOf(v, level)));
        return ticks;
    }

    std::vector<std::size_t> unknownOf(const std::vector<std::vector<std::size_t>>& lists) const
    {
        std::vector<std::size_t> points;
        forEachCombination(lists, [&](const GridPlace& place) {
            if (const std::size_t point = gridPoint(m_study, place); !m_heldAt(point))
                points.push_back(point);
        });
        return points;
    }

    // Of the places of half of this step in boxes of this step whose outcomes differ.
    std::vector<std::size_t> unknownOfMixed(std::size_t level) const
    {
        const auto ticks = ticksAt(level);
        std::vector<std::vector<std::size_t>> boxes; // by the numbers of their lower ticks
        for (const auto& along : ticks) {
            boxes.emplace_back(std::max<std::size_t>(1, along.size() - 1));
            std::iota(boxes.back().begin(), boxes.back().end(), 0);
        }
        std::set<std::size_t> points;
        forEachCombination(boxes, [&](const GridPlace& box) {
            std::vector<std::vector<std::size_t>> inside;
            for (std::size_t v = 0; v < box.size(); ++v) {
                const std::size_t low = ticks[v][box[v]];
                const std::size_t high = ticks[v][std::min(box[v] + 1, ticks[v].size() - 1)];
                auto& list = inside.emplace_back();
                for (std::size_t i = low; i < high; i += stepOf(v, level / 2))
                    list.push_back(i);
                list.push_back(high);
            }
            bool hasHeld = false, hasFailed = false;
            std::vector<std::size_t> unknown;
            forEachCombination(inside, [&](const GridPlace& place) {
                const std::size_t point = gridPoint(m_study, place);
                const auto held = m_heldAt(point);
                hasHeld |= held == true;
                hasFailed |= held == false;
                if (!held)
                    unknown.push_back(point);
            });
            if (hasHeld && hasFailed)
                points.insert(unknown.begin(), unknown.end());
        });
        return {points.begin(), points.end()};
    }

    const Study& m_study;
    const HeldAt& m_heldAt;
    std::vector<std::size_t> m_values; // [variables] how many
    std::vector<std::size_t> m_coarse; // [variables] step of the coarse grid
};

} // namespace

std::vector<std::size_t> frontierPoints(const Study& study, const HeldAt& heldAt)
{
    return study.variables.empty() ? std::vector<std::size_t>() : Search(study, heldAt).next();
}

} // namespace ripstop
