// Lists of lists in two arrays, as sparse matrices keep them (compressed rows).
//
// Two arrays take less memory than a vector for each row, and are gone through in order of memory.
// The incidence lists of a System (springsAt, panelsAt, ...) are Rows, and a row in ascending order
// is what gives sums over it the same bits in every run.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace ripstop {

// Row i is items[start[i]] .. items[start[i + 1]].
struct Rows
{
    std::vector<int> start; // [rows + 1]
    std::vector<int> items;

    friend bool operator==(const Rows&, const Rows&) = default;
};

// Fills `rows` with the items that name each of `count` targets, in ascending order of item.
//   targetsOf(item)  the targets, 0 .. count - 1, that an item names
template <typename Items, typename TargetsOf>
void fillIncidence(Rows& rows, std::size_t count, const Items& items, TargetsOf targetsOf)
{
    rows.start.assign(count + 1, 0);
    for (const auto& item : items)
        for (const int target : targetsOf(item))
            ++rows.start[std::size_t(target) + 1];
    std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());
    rows.items.resize(std::size_t(rows.start.back()));
    std::vector<int> next(rows.start.begin(), rows.start.end() - 1);
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const int target : targetsOf(items[i]))
            rows.items[std::size_t(next[std::size_t(target)]++)] = int(i);
}

} // namespace ripstop
