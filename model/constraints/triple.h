// Three particles that share an energy, as the direct solver has them (direct_solver.h): what a
// panel or the bend of a spar is to its matrix.
#pragma once

#include "base/vec3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ripstop {

inline constexpr std::array<std::pair<std::size_t, std::size_t>, 3> sidesOfTriple{
    {{0, 1}, {1, 2}, {2, 0}}};

struct Triple
{
    std::array<std::uint32_t, 3> row{};    // of the solver's positions; pins come last
    std::array<int, 3> pair{{-1, -1, -1}}; // in the matrix, by side; -1 where an end is pinned
    bool gone = false;
};

inline std::uint32_t firstRow(const Triple& triple)
{
    return std::min({triple.row[0], triple.row[1], triple.row[2]});
}

// What one adds to the matrix and to the right-hand side.
struct TripleBlock
{
    std::array<Mat3, 3> corner; // on the diagonal
    std::array<Mat3, 3> pair;   // by side: rows of the first corner, columns of the second
    std::array<Vec3, 3> pull;   // kg m
};

// Adds the sides between two of the first `nodes` rows to the pairs of the matrix.
inline void numberPairs(Triple& triple, std::size_t nodes, std::vector<std::pair<int, int>>& pairs)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triple.row[sidesOfTriple[k].first];
        const std::uint32_t to = triple.row[sidesOfTriple[k].second];
        triple.pair[k] = -1;
        if (from >= nodes || to >= nodes)
            continue;
        triple.pair[k] = int(pairs.size());
        pairs.emplace_back(from, to);
    }
}

} // namespace ripstop
