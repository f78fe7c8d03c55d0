// facingAlike(): the sides of all panels are sorted, so that the two panels of an inner edge come
// next to each other; two panels that run along their edge in the same direction face opposite
// ways. A walk from panel to panel through these neighbours then decides for each panel whether it
// is turned, beginning anew in each connected piece.
//
// laySideBySide() walks likewise, outwards from the first panel of each piece. clothVertices()
// keeps for each particle a list of the vertices that it has so far.
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

// Visits each panel but the first of a piece of fabric, from a neighbour that was visited before,
// ring by ring.
template <typename Visit> // (panel, its neighbour that is new)
void walkOutwards(const std::vector<std::vector<Neighbour>>& neighbours, Visit visit)
{
    std::vector<std::uint8_t> seen(neighbours.size(), 0);
    std::vector<int> queue;
    for (int seed = 0; seed < int(neighbours.size()); ++seed) {
        if (seen[seed])
            continue;
        seen[seed] = 1;
        queue.assign(1, seed);
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const Neighbour& next : neighbours[queue[at]]) {
                if (seen[next.panel])
                    continue;
                seen[next.panel] = 1;
                visit(queue[at], next);
                queue.push_back(next.panel);
            }
    }
}

} // namespace

std::vector<Corners> facingAlike(std::span<const Corners> panels)
{
    const auto neighbours = neighboursOf(panels);
    std::vector<Corners> result(panels.begin(), panels.end());
    std::vector<std::uint8_t> turned(panels.size(), 0);
    walkOutwards(neighbours, [&](int panel, const Neighbour& next) {
        turned[next.panel] = turned[panel] != std::uint8_t(next.opposed);
    });
    for (std::size_t p = 0; p < panels.size(); ++p)
        if (turned[p])
            std::swap(result[p][1], result[p][2]);
    return result;
}

namespace {

// The corner of the panel that this particle is at; 0 when it is at none.
std::size_t cornerOf(const Corners& panel, int particle)
{
    return std::size_t(std::ranges::find(panel, particle) - panel.begin()) % 3;
}

// Shifts `next` to where `laid` has the side that both share.
void layBeside(const Corners& panel, const std::array<ClothPoint, 3>& laid,
               const Corners& nextPanel, std::array<ClothPoint, 3>& next)
{
    std::array<std::size_t, 2> here{}, there{};
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3 && shared < 2; ++i)
        if (std::ranges::find(nextPanel, panel[i]) != nextPanel.end()) {
            here[shared] = i;
            there[shared++] = cornerOf(nextPanel, panel[i]);
        }
    if (shared < 2)
        return;
    double along = 0.0;
    for (std::size_t axis = 0; axis < 2; ++axis)
        along += double(laid[here[1]][axis] - laid[here[0]][axis])
                 * double(next[there[1]][axis] - next[there[0]][axis]);
    const float sense = along < 0.0 ? -1.0F : 1.0F;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const float middle = 0.5F * (laid[here[0]][axis] + laid[here[1]][axis]);
        const float from = 0.5F * sense * (next[there[0]][axis] + next[there[1]][axis]);
        for (ClothPoint& point : next)
            point[axis] = sense * point[axis] + (middle - from);
    }
}

} // namespace

void laySideBySide(std::span<const Corners> panels, std::span<std::array<ClothPoint, 3>> points)
{
    walkOutwards(neighboursOf(panels), [&](int panel, const Neighbour& next) {
        layBeside(panels[panel], points[panel], panels[next.panel], points[next.panel]);
    });
}

namespace {

bool isSame(const ClothPoint& a, const ClothPoint& b)
{
    constexpr float near = 5e-4F; // m; a tenth of a thread of the grid
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::abs(a[i] - b[i]) > near)
            return false;
    return true;
}

} // namespace

ClothVertices clothVertices(std::span<const Corners> panels,
                            std::span<const std::array<ClothPoint, 3>> points,
                            std::size_t particles)
{
    ClothVertices result;
    result.corners.resize(panels.size());
    std::vector<int> first(particles, -1), next;
    for (std::size_t p = 0; p < panels.size(); ++p)
        for (std::size_t i = 0; i < 3; ++i) {
            const int particle = panels[p][i];
            const ClothPoint& point = points[p][i];
            int vertex = first[particle];
            while (vertex >= 0 && !isSame(result.point[vertex], point))
                vertex = next[vertex];
            if (vertex < 0) {
                vertex = int(result.particle.size());
                result.particle.push_back(particle);
                result.point.push_back(point);
                next.push_back(first[particle]);
                first[particle] = vertex;
            }
            result.corners[p][i] = vertex;
        }
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
