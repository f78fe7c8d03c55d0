// How a click or a rubber band changes what is selected, alike in all pictures of a study and in
// its table: Ctrl takes to or from the selection, Shift adds to it, and neither begins anew.
#pragma once

#include <Qt>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ripstop {

enum class Picking { Replace, Toggle, Add };

inline Picking pickingOf(Qt::KeyboardModifiers keys)
{
    if (keys.testFlag(Qt::ControlModifier))
        return Picking::Toggle;
    return keys.testFlag(Qt::ShiftModifier) ? Picking::Add : Picking::Replace;
}

// In the order in which they were picked.
inline std::vector<std::size_t> pickedOf(std::vector<std::size_t> before,
                                         const std::vector<std::size_t>& points, Picking how)
{
    if (how == Picking::Replace)
        return points;
    if (how == Picking::Toggle && points.size() == 1 && std::erase(before, points.front()) > 0)
        return before;
    std::vector<std::size_t> known = before;
    std::ranges::sort(known);
    for (const std::size_t point : points)
        if (!std::ranges::binary_search(known, point))
            before.push_back(point);
    return before;
}

// [count] 1 for what is picked; empty where nothing is, which is drawn as if all were.
inline std::vector<char> marksOf(const std::vector<std::size_t>& picked, std::size_t count)
{
    std::vector<char> marks(picked.empty() ? 0 : count, 0);
    for (const std::size_t point : picked)
        if (point < marks.size())
            marks[point] = 1;
    return marks;
}

} // namespace ripstop
