// One particle on a spring, the system on which integrators are judged: x'' = -omega^2 x has the
// solution x = cos(omega t) for x0 = 1 m and v0 = 0, and each scheme has amplification and phase
// that theory gives exactly. The cases of integrators and of damping measure on it.
#pragma once

#include "verify/sections.h"
#include "verify/small_systems.h"

#include <array>
#include <numbers>

namespace ripstop {

inline constexpr double omega = 2.0 * std::numbers::pi; // 1/s

// NaiveVerlet is Verlet whose previous position is x0 - v0 dt.
enum class Scheme {
    ExplicitEuler,
    SemiImplicitEuler,
    Verlet,
    NaiveVerlet,
    VelocityVerlet,
    RungeKutta4
};

inline constexpr std::array allSchemes{Scheme::ExplicitEuler,  Scheme::SemiImplicitEuler,
                                       Scheme::Verlet,         Scheme::NaiveVerlet,
                                       Scheme::VelocityVerlet, Scheme::RungeKutta4};

Integrator integratorOf(Scheme scheme);
std::string nameOf(Scheme scheme);

// A particle of 1 kg on a spring without rest length, pinned at `anchor`: F = -k x in all
// directions and at any amplitude. x0 = 1 m, v0 = 0. The spring turns at `frequency`, 1/s.
System oscillator(Scheme scheme, double timeStep, double frequency = omega, double damping = 0.0,
                  const Vec3& anchor = Vec3::Zero());

// x and v after each step. For Verlet, whose own velocity lags by half a step, v is the mean of the
// two velocities around the instant, which is the central difference.
struct OscillatorTrace
{
    std::vector<double> x; // [steps + 1] m
    std::vector<double> v; // [steps + 1] m/s
};

OscillatorTrace follow(const System& system, int steps);

} // namespace ripstop
