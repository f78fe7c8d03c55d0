#include "shapes/triangle_point.h"

namespace ripstop {

Vec3 nearestShares(const Corners& x, const Vec3& point)
{
    const Vec3 ab = x[1] - x[0], ac = x[2] - x[0];
    const Vec3 ap = point - x[0], bp = point - x[1], cp = point - x[2];
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0)
        return {1.0, 0.0, 0.0};
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3)
        return {0.0, 1.0, 0.0};
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6)
        return {0.0, 0.0, 1.0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        return {d3 / (d3 - d1), d1 / (d1 - d3), 0.0};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - t, t};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        return {d6 / (d6 - d2), 0.0, d2 / (d2 - d6)};
    const double sum = va + vb + vc;
    return sum > 0.0 ? Vec3(va / sum, vb / sum, vc / sum) : Vec3(1.0, 0.0, 0.0);
}

} // namespace ripstop
