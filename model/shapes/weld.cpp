// Joins points that lie on each other. Points that stay are sorted into cells that are larger than
// the tolerance, so that most of them look into one cell; each point looks into the cells around
// it for the nearest one that stays, and joins it or stays itself.
#include "shapes/polygon_split.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace ripstop {
namespace {

constexpr double cellOverTolerance = 8.0;
constexpr double finestCell = 1e-9; // over the size of the mesh, so that cells can be counted

using Cell = std::array<std::int64_t, 3>;

struct CellHash
{
    std::size_t operator()(const Cell& cell) const
    {
        std::uint64_t hash = 0;
        for (const std::int64_t part : cell) {
            hash = (hash ^ std::uint64_t(part)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

double largestCoordinate(const std::vector<Vec3>& points)
{
    double largest = 0.0;
    for (const Vec3& point : points)
        largest = std::max(largest, point.cwiseAbs().maxCoeff());
    return largest;
}

} // namespace

std::vector<int> welded(const std::vector<Vec3>& points, double tolerance)
{
    const double size =
        std::max({cellOverTolerance * tolerance, finestCell * largestCoordinate(points),
                  std::numeric_limits<double>::min()});
    const auto along = [size](double x) { return std::int64_t(std::floor(x / size)); };

    std::unordered_map<Cell, int, CellHash> newest; // the last point that is kept in a cell
    newest.reserve(points.size());
    std::vector<int> before(points.size(), -1); // the one before it in its cell
    std::vector<int> target(points.size());
    for (int i = 0; i < int(points.size()); ++i) {
        const Vec3& point = points[std::size_t(i)];
        int nearest = i;
        double best = tolerance;
        const Vec3 low = point.array() - tolerance;
        const Vec3 high = point.array() + tolerance;
        for (std::int64_t x = along(low.x()); x <= along(high.x()); ++x)
            for (std::int64_t y = along(low.y()); y <= along(high.y()); ++y)
                for (std::int64_t z = along(low.z()); z <= along(high.z()); ++z) {
                    const auto found = newest.find({x, y, z});
                    if (found == newest.end())
                        continue;
                    for (int other = found->second; other >= 0;
                         other = before[std::size_t(other)]) {
                        const double distance = (points[std::size_t(other)] - point).norm();
                        // the first of equally near ones wins, whatever the order in the cell
                        const bool isNearer =
                            distance < best
                            || (distance == best && (nearest == i || other < nearest));
                        if (isNearer) {
                            best = distance;
                            nearest = other;
                        }
                    }
                }
        target[std::size_t(i)] = nearest;
        if (nearest != i)
            continue;
        const auto [place, isNew] =
            newest.emplace(Cell{along(point.x()), along(point.y()), along(point.z())}, i);
        if (!isNew) {
            before[std::size_t(i)] = place->second;
            place->second = i;
        }
    }
    return target;
}

} // namespace ripstop
