#include "measure/attitude.h"

#include "measure/motion.h"
#include "measure/wing_forces.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double degrees = 180.0 / std::numbers::pi;

// Nose, right and up, of length 1 and across each other; not numbers when a particle is missing.
struct Axes
{
    Vec3 ahead;
    Vec3 right;
    Vec3 up;
};

Vec3 aheadOf(const ProbeSpec& probe, Readings& readings)
{
    if (probe.from < 0)
        return Vec3::Constant(nothing);
    const State& state = readings.state();
    const Vec3 nose = meanOf(probe, readings.system(), state.position);
    return (nose - state.position[std::size_t(probe.from)]).normalized();
}

Axes axesOf(const ProbeSpec& probe, Readings& readings)
{
    const Vec3 none = Vec3::Constant(nothing);
    if (probe.from < 0 || probe.side < 0)
        return {none, none, none};
    const auto& position = readings.state().position;
    const Vec3 ahead = aheadOf(probe, readings);
    Vec3 right = position[std::size_t(probe.side)] - position[std::size_t(probe.from)];
    right -= right.dot(ahead) * ahead;
    right.normalize();
    return {ahead, right, right.cross(ahead)};
}

} // namespace

double pitch(const ProbeSpec& probe, Readings& readings)
{
    const Vec3 ahead = aheadOf(probe, readings);
    return std::atan2(ahead.y(), std::hypot(ahead.x(), ahead.z())) * degrees;
}

double heading(const ProbeSpec& probe, Readings& readings)
{
    const Vec3 ahead = aheadOf(probe, readings);
    return std::atan2(ahead.z(), ahead.x()) * degrees;
}

double roll(const ProbeSpec& probe, Readings& readings)
{
    const Axes axes = axesOf(probe, readings);
    return std::atan2(-axes.right.y(), axes.up.y()) * degrees;
}

double angleOfAttack(const ProbeSpec& probe, Readings& readings)
{
    const Axes axes = axesOf(probe, readings);
    const Vec3 wind = relativeWind(probe, readings);
    return std::atan2(wind.dot(axes.up), -wind.dot(axes.ahead)) * degrees;
}

} // namespace ripstop
