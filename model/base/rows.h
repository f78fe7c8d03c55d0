// Lists of lists in two arrays, as sparse matrices keep them.
#pragma once

#include <vector>

namespace ripstop {

// Row i is items[start[i]] .. items[start[i + 1]].
struct Rows
{
    std::vector<int> start; // [rows + 1]
    std::vector<int> items;

    friend bool operator==(const Rows&, const Rows&) = default;
};

} // namespace ripstop
