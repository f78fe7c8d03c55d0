// Gusts: drydenGusts() makes lengths and strengths of height and wind, firstGust() draws the states
// that a run begins with, advanceGust() steps them by the exact solution over the way that the air
// goes in a time step, and velocityOf() makes the wind of them.
//
// Numbers are drawn by a hash of seed, step and axis, so that a replay needs no generator and no
// memory of how many were drawn before. Logarithm and exponential are the portable ones
// (base/portable_math.h), so that the same seed gives the same bits on every machine.
#include "forces/gusts.h"

#include "base/portable_math.h"
#include "base/split_mix.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double foot = 0.3048; // m

struct Pair
{
    double first;
    double second;
};

// Two independent numbers of the normal distribution, by the polar method (Marsaglia and Bray
// 1964).
Pair normals(std::uint64_t seed, std::int64_t step, std::uint64_t which)
{
    std::uint64_t key = splitMix(splitMix(splitMix(seed) ^ std::uint64_t(step)) ^ which);
    const auto next = [&] { // in (-1, 1)
        key = splitMix(key);
        return (double(key >> 11) + 0.5) * 0x1p-52 - 1.0;
    };
    for (;;) {
        const double u = next();
        const double v = next();
        const double s = u * u + v * v;
        if (s >= 1.0 || s == 0.0)
            continue;
        const double scale = std::sqrt(-2.0 * portableLog(s) / s);
        return {u * scale, v * scale};
    }
}

// The exact step of the two states over a distance of `d` lengths: A = r [[1, 0], [d, 1]] and noise
// of covariance P - A P A^T, by its Cholesky factor.
void advance(std::array<double, 2>& x, double d, const Pair& n)
{
    const double r = portableExp(-d);
    const double square = r * r;
    const double q11 = 1.0 - square;
    const double q12 = 0.5 - square * (d + 0.5);
    const double q22 = 0.5 - square * (d * d + d + 0.5);
    const double l11 = std::sqrt(std::max(0.0, q11));
    const double l21 = l11 > 0.0 ? q12 / l11 : 0.0;
    const double l22 = std::sqrt(std::max(0.0, q22 - l21 * l21));
    x[1] = r * (d * x[0] + x[1]) + l21 * n.first + l22 * n.second;
    x[0] = r * x[0] + l11 * n.first;
}

double transverse(const std::array<double, 2>& x)
{
    const double root3 = std::sqrt(3.0);
    return (root3 * x[0] + (1.0 - root3) * x[1]) / std::sqrt(2.0);
}

} // namespace

GustSpec drydenGusts(Key key, const Vec3& mean, double height, double windAt20Feet, int seed)
{
    GustSpec gusts;
    gusts.key = key;
    const Vec3 level(mean.x(), 0.0, mean.z());
    gusts.along = level.norm() > 0.0 ? Vec3(level.normalized()) : Vec3(Vec3::UnitX());
    gusts.across = gusts.along.cross(Vec3::UnitY());
    gusts.speed = std::max(1.0, level.norm());
    const double feet = std::clamp(height / foot, 10.0, 1000.0);
    const double slope = portableLog(0.177 + 0.000823 * feet);
    gusts.lengthUp = feet * foot;
    gusts.lengthAlong = gusts.lengthUp * portableExp(-1.2 * slope);
    gusts.sigmaUp = 0.1 * windAt20Feet;
    gusts.sigmaAlong = gusts.sigmaUp * portableExp(-0.4 * slope);
    gusts.seed = seed;
    return gusts;
}

GustState firstGust(const GustSpec& gusts)
{
    const auto seed = std::uint64_t(gusts.seed);
    const auto state = [&](std::uint64_t which) {
        const Pair n = normals(seed, -1, which);
        return std::array{n.first, 0.5 * (n.first + n.second)};
    };
    return {normals(seed, -1, 0).first, state(1), state(2)};
}

void advanceGust(const GustSpec& gusts, double timeStep, std::int64_t step, GustState& state)
{
    const auto seed = std::uint64_t(gusts.seed);
    const double distance = gusts.speed * timeStep;
    const double d = distance / gusts.lengthAlong;
    const double r = portableExp(-d);
    state.along =
        r * state.along + std::sqrt(std::max(0.0, 1.0 - r * r)) * normals(seed, step, 0).first;
    advance(state.across, d, normals(seed, step, 1));
    advance(state.up, distance / gusts.lengthUp, normals(seed, step, 2));
}

void startGusts(System& system)
{
    system.start.gusts.clear();
    for (const GustSpec& gusts : system.gusts)
        system.start.gusts.push_back(firstGust(gusts));
}

void advanceGusts(const System& system, State& state)
{
    for (std::size_t i = 0; i < system.gusts.size(); ++i)
        advanceGust(system.gusts[i], system.timeStep, state.step, state.gusts[i]);
}

Vec3 velocityOf(const GustSpec& gusts, const GustState& state)
{
    return gusts.sigmaAlong * (state.along * gusts.along + transverse(state.across) * gusts.across)
           + gusts.sigmaUp * transverse(state.up) * Vec3::UnitY();
}

} // namespace ripstop
