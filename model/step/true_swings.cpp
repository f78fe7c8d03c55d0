#include "step/true_swings.h"

#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;

constexpr double share = 0.01;

double largestAngle(Integrator integrator, bool held) // rad, that a swing goes on in a substep
{
    if (integrator == Integrator::Bdf2)
        return std::sqrt(3.0 * share);
    if (held)
        return share / pi;
    switch (integrator) {
    case Integrator::ExplicitEuler:
    case Integrator::ImplicitEuler:
        return share / pi;
    case Integrator::RungeKutta4:
        return std::pow(144.0 * share / (2.0 * pi), 0.2);
    default:
        return std::sqrt(24.0 * share);
    }
}

} // namespace

double fastestTrueSwing(Integrator integrator, bool held, double substep)
{
    return largestAngle(integrator, held) / (2.0 * pi * substep);
}

} // namespace ripstop
