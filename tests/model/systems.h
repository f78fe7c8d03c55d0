// Small systems made by hand, and the words with which a test reports a number.
//
// Add particles and what joins them, set what the test is about, call finish(system), then run().
#pragma once

#include "sim/stepper.h"
#include "sim/system.h"

#include <cmath>
#include <cstdio>
#include <random>

namespace ripstop {

inline constexpr double standardGravity = 9.80665; // m/s^2

// One substep of `timeStep` seconds, no gravity, calm air; the rest as a System starts.
inline System emptySystem(double timeStep, Integrator integrator = Integrator::SemiImplicitEuler)
{
    System system;
    system.timeStep = timeStep;
    system.substeps = 1;
    system.integrator = integrator;
    system.gravity = Vec3::Zero();
    return system;
}

// Index of the new particle.
inline int addParticle(System& system, const Vec3& position, double mass,
                       const Vec3& velocity = Vec3::Zero())
{
    system.start.position.push_back(position);
    system.start.velocity.push_back(velocity);
    system.inverseMass.push_back(1.0 / mass);
    system.mass.push_back(mass);
    return int(system.start.position.size()) - 1;
}

inline int addPin(System& system, const Vec3& position, double mass = 1.0)
{
    const int index = addParticle(system, position, mass);
    system.inverseMass.back() = 0.0;
    return index;
}

inline double distance(const System& system, int a, int b)
{
    return (system.start.position[std::size_t(b)] - system.start.position[std::size_t(a)]).norm();
}

inline Spring& addSpring(System& system, int a, int b, double restLength, double stiffness,
                         double damping = 0.0)
{
    system.springs.push_back({a, b, restLength, stiffness, damping, Resists::Both, {}});
    return system.springs.back();
}

inline Rod& addRod(System& system, int a, int b, double restLength, double compliance = 0.0)
{
    system.rods.push_back({a, b, restLength, compliance, Resists::Both, {}});
    return system.rods.back();
}

inline void addPanel(System& system, int a, int b, int c, AirLaw law, double normalCoefficient,
                     double skinFriction = 0.0)
{
    MaterialAir air;
    air.law = law;
    air.normalCoefficient = normalCoefficient;
    air.skinFriction = skinFriction;
    if (system.materialAir.empty() || system.materialAir.back() != air)
        system.materialAir.push_back(air);
    system.panels.push_back({{a, b, c}, int(system.materialAir.size()) - 1});
}

// The state after so many time steps from `state`.
inline State run(const System& system, State state, int steps, int threads = 1)
{
    Stepper stepper(threads);
    for (int i = 0; i < steps; ++i)
        stepper.step(system, state);
    return state;
}

inline State run(const System& system, int steps, int threads = 1)
{
    return run(system, system.start, steps, threads);
}

inline bool isNear(double got, double expected, double tolerance)
{
    return std::abs(got - expected) <= tolerance;
}

inline bool isNear(const Vec3& got, const Vec3& expected, double tolerance)
{
    return (got - expected).norm() <= tolerance;
}

// For QVERIFY2: lives until the next call.
inline const char* told(double got, double expected)
{
    static char text[120];
    std::snprintf(text, sizeof text, "got %.12g, expected %.12g, difference %.3g", got, expected,
                  got - expected);
    return text;
}

inline const char* told(const Vec3& got, const Vec3& expected)
{
    static char text[240];
    std::snprintf(text, sizeof text,
                  "got (%.12g, %.12g, %.12g), expected (%.12g, %.12g, %.12g), difference %.3g",
                  got.x(), got.y(), got.z(), expected.x(), expected.y(), expected.z(),
                  (got - expected).norm());
    return text;
}

// Numbers that are the same in every run and with every standard library.
class Dice
{
public:
    explicit Dice(std::uint32_t seed)
        : m_engine(seed)
    {}
    double operator()(double low, double high)
    {
        return low + (high - low) * (double(m_engine()) / 4294967296.0);
    }
    Vec3 vector(double size)
    {
        const double x = (*this)(-size, size);
        const double y = (*this)(-size, size);
        const double z = (*this)(-size, size);
        return {x, y, z};
    }
    int below(int count) { return int(m_engine() % std::uint32_t(count)); }

private:
    std::mt19937 m_engine;
};

} // namespace ripstop
