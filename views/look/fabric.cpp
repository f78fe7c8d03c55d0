// facingAlike(): the sides of all panels are sorted, so that the two panels of an inner edge come
// next to each other; two panels that run along their edge in the same direction face opposite
// ways. A walk from panel to panel through these neighbours then decides for each panel whether it
// is turned, beginning anew in each connected piece.
//
// smoothNormals(): adds the normal of each panel, twice its area long, to its corners, and makes
// the sums unit.
#include "look/fabric.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ripstop {
namespace {

// One side of one panel, the particles in ascending order.
struct Side
{
    int low;
    int high;
    int panel;
    bool ascending; // whether the panel runs from low to high
};

struct Neighbour
{
    int panel;
    bool opposed; // the two panels face opposite ways
};

std::vector<Side> sortedSides(std::span<const Corners> panels)
{
    std::vector<Side> sides;
    sides.reserve(3 * panels.size());
    for (int p = 0; p < int(panels.size()); ++p)
        for (int i = 0; i < 3; ++i) {
            const int a = panels[p][i], b = panels[p][(i + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), p, a < b});
        }
    std::ranges::sort(sides, [](const Side& s, const Side& t) {
        return std::tie(s.low, s.high, s.panel) < std::tie(t.low, t.high, t.panel);
    });
    return sides;
}

std::vector<std::vector<Neighbour>> neighboursOf(std::span<const Corners> panels)
{
    const std::vector<Side> sides = sortedSides(panels);
    std::vector<std::vector<Neighbour>> neighbours(panels.size());
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t end = first + 1;
        while (end < sides.size() && sides[end].low == sides[first].low
               && sides[end].high == sides[first].high)
            ++end;
        if (end - first == 2) {
            const Side& s = sides[first];
            const Side& t = sides[first + 1];
            const bool opposed = s.ascending == t.ascending;
            neighbours[s.panel].push_back({t.panel, opposed});
            neighbours[t.panel].push_back({s.panel, opposed});
        }
        first = end;
    }
    return neighbours;
}

} // namespace

std::vector<Corners> facingAlike(std::span<const Corners> panels)
{
    const auto neighbours = neighboursOf(panels);
    std::vector<Corners> result(panels.begin(), panels.end());
    std::vector<std::uint8_t> seen(panels.size(), 0), turned(panels.size(), 0);
    std::vector<int> queue;
    for (int seed = 0; seed < int(panels.size()); ++seed) {
        if (seen[seed])
            continue;
        seen[seed] = 1;
        queue.assign(1, seed);
        while (!queue.empty()) {
            const int panel = queue.back();
            queue.pop_back();
            for (const Neighbour& next : neighbours[panel]) {
                if (seen[next.panel])
                    continue;
                seen[next.panel] = 1;
                turned[next.panel] = turned[panel] != std::uint8_t(next.opposed);
                queue.push_back(next.panel);
            }
        }
    }
    for (std::size_t p = 0; p < panels.size(); ++p)
        if (turned[p])
            std::swap(result[p][1], result[p][2]);
    return result;
}

void smoothNormals(std::span<const Corners> panels, std::span<const std::uint8_t> present,
                   std::span<const Vec3> position, std::span<std::array<float, 3>> normal)
{
    std::ranges::fill(normal, std::array<float, 3>{0.0F, 0.0F, 0.0F});
    for (std::size_t p = 0; p < panels.size(); ++p) {
        if (!present[p])
            continue;
        const auto [a, b, c] = panels[p];
        // its length is twice the area, which is the weight
        const Vec3 n = (position[b] - position[a]).cross(position[c] - position[a]);
        for (const int corner : panels[p])
            for (int i = 0; i < 3; ++i)
                normal[corner][i] += float(n[i]);
    }
    for (auto& n : normal) {
        const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (length > 0.0F)
            for (float& component : n)
                component /= length;
        else
            n = {0.0F, 1.0F, 0.0F}; // a black spot where panels cancel would look like a hole
    }
}

} // namespace ripstop
