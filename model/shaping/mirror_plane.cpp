// Places are taken from the middle of the box around them; sums then say how even they are.
#include "shaping/mirror_plane.h"

#include "shaping/fabric_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double flat = 1e-3;  // of the longest side of the box
constexpr double alike = 1e-6; // of unevenness
constexpr std::array order{2, 0, 1};

// 0 for what is the same to both sides, 1 for what lies on one.
double unevenness(const std::vector<Vec3>& places, const Vec3& middle, int axis)
{
    double first = 0.0, third = 0.0, all = 0.0, cubes = 0.0;
    for (const Vec3& place : places) {
        const double way = place[axis] - middle[axis];
        first += way;
        third += way * way * way;
        all += std::abs(way);
        cubes += std::abs(way * way * way);
    }
    return std::max(std::abs(first) / all, std::abs(third) / cubes);
}

} // namespace

MirrorPlane mirrorPlaneOf(const Part& part)
{
    const std::vector<Vec3> places = fabricPlacesOf(part);
    Eigen::AlignedBox3d box;
    for (const Vec3& place : places)
        box.extend(place);
    if (box.isEmpty())
        return {};
    const Vec3 middle = box.center(), sides = box.sizes();
    MirrorPlane best{0, middle[0]};
    double least = std::numeric_limits<double>::max();
    for (const int axis : order) {
        if (!(sides[axis] > flat * sides.maxCoeff()))
            continue;
        const double here = unevenness(places, middle, axis);
        if (here < least - alike) {
            least = here;
            best = {axis, middle[axis]};
        }
    }
    return best;
}

Id partNearest(const Scene& scene, const Vec3& place)
{
    Id nearest = noId;
    double least = std::numeric_limits<double>::infinity();
    forEachPart(scene, [&](Id id, const Part& part) {
        for (const Particle& row : part.particles)
            if (const double way = (row.position - place).squaredNorm(); way < least) {
                least = way;
                nearest = id;
            }
    });
    return nearest;
}

} // namespace ripstop
