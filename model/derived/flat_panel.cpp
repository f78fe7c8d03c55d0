// flatPanel() lays a triangle out by the lengths of its sides and turns it by its grain; all else
// follows from that or from where the corners are. A grain is told from 0 to 180 degrees, as a warp
// runs both ways.
#include "derived/flat_panel.h"

#include "base/angle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ripstop {
namespace {

constexpr double thinnest = 1e-9; // of the square of the longest side, four times the area

} // namespace

std::optional<FlatPanel> flatPanel(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const auto length = [](double given, const Vec3& from, const Vec3& to) {
        return given > 0.0 ? given : (to - from).norm();
    };
    const double ab = length(panel.restAB, a, b);
    const double bc = length(panel.restBC, b, c);
    const double ca = length(panel.restCA, c, a);
    const double longest = std::max({ab, bc, ca});
    if (!(ab > 0.0))
        return std::nullopt;
    const double along = (ab * ab + ca * ca - bc * bc) / (2.0 * ab);
    const double square = ca * ca - along * along;
    if (!(square > 0.0) || !(2.0 * ab * std::sqrt(square) > thinnest * longest * longest))
        return std::nullopt;
    const double across = std::sqrt(square);
    const double cosine = std::cos(panel.grain * degrees);
    const double sine = std::sin(panel.grain * degrees);
    return FlatPanel{{ab * cosine, -ab * sine},
                     {along * cosine + across * sine, across * cosine - along * sine}};
}

double cutArea(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const std::optional<FlatPanel> flat = flatPanel(panel, a, b, c);
    return flat ? flat->area() : 0.5 * (b - a).cross(c - a).norm();
}

std::optional<std::array<double, 2>> warpShares(const Panel& panel, const Vec3& a, const Vec3& b,
                                                const Vec3& c)
{
    const std::optional<FlatPanel> flat = flatPanel(panel, a, b, c);
    if (!flat)
        return std::nullopt;
    const double twice = 2.0 * flat->area();
    return std::array{flat->ac.y() / twice, -flat->ab.y() / twice};
}

double grainAlong(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& warp)
{
    const Vec3 along = (b - a).normalized();
    const Vec3 across = ((c - a) - (c - a).dot(along) * along).normalized();
    const double x = warp.dot(along);
    const double y = warp.dot(across);
    const bool lies = std::hypot(x, y) > 1e-6 * warp.norm();
    const double angle = lies ? std::atan2(y, x) / degrees : 0.0;
    return angle < 0.0 ? angle + 180.0 : angle;
}

double turnedGrain(double grain, double turn)
{
    const double rest = std::fmod(grain + turn, 180.0);
    return rest < 0.0 ? rest + 180.0 : rest;
}

Panel turnedOver(const Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c)
{
    Panel turned = panel;
    std::swap(turned.b, turned.c);
    std::swap(turned.restAB, turned.restCA);
    Panel plain = panel;
    plain.grain = 0.0;
    if (const std::optional<FlatPanel> flat = flatPanel(plain, a, b, c)) {
        const double corner = std::atan2(flat->ac.y(), flat->ac.x()) / degrees;
        turned.grain = corner - panel.grain;
        if (turned.grain < 0.0)
            turned.grain += 180.0;
    }
    return turned;
}

void layFlat(Panel& panel, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& warp)
{
    panel.restAB = (b - a).norm();
    panel.restBC = (c - b).norm();
    panel.restCA = (a - c).norm();
    panel.grain = grainAlong(a, b, c, warp);
}

Vec3 uprightWarp(const std::array<Vec3, 3>& corners,
                 const std::array<PolygonMesh::TexturePoint, 3>& texture)
{
    const Vec3 ab = corners[1] - corners[0];
    const Vec3 ac = corners[2] - corners[0];
    const double ub = texture[1][0] - texture[0][0], uc = texture[2][0] - texture[0][0];
    const double vb = texture[1][1] - texture[0][1], vc = texture[2][1] - texture[0][1];
    const double turn = ub * vc - uc * vb;
    const double largest = std::max({std::abs(ub), std::abs(uc), std::abs(vb), std::abs(vc)});
    const bool isPrinted = std::abs(turn) > thinnest * largest * largest && largest > 0.0;
    const Vec3 across = ab.cross(ac);
    const bool isLevel = std::hypot(across.x(), across.z()) < 1e-3 * across.norm();
    return isPrinted ? Vec3((ub * ac - uc * ab) / turn)
           : isLevel ? Vec3(Vec3::UnitX())
                     : Vec3(Vec3::UnitY());
}

namespace {

Vec3 warpOf(const Particle& a, const Particle& b, const Particle& c)
{
    return uprightWarp(
        {a.position, b.position, c.position},
        {{{a.textureU, a.textureV}, {b.textureU, b.textureV}, {c.textureU, c.textureV}}});
}

} // namespace

double uprightGrain(const Particle& a, const Particle& b, const Particle& c)
{
    return grainAlong(a.position, b.position, c.position, warpOf(a, b, c));
}

double grainTurn(const Panel& panel, const Particle& a, const Particle& b, const Particle& c)
{
    constexpr double rounding = 1e-9; // degrees
    const double turn = std::remainder(panel.grain - uprightGrain(a, b, c), 180.0);
    // a warp across is the same either way, whatever rounding made of it
    return turn < rounding - 90.0 ? turn + 180.0 : turn;
}

void layFlat(Panel& panel, const Particle& a, const Particle& b, const Particle& c)
{
    layFlat(panel, a.position, b.position, c.position, warpOf(a, b, c));
}

} // namespace ripstop
