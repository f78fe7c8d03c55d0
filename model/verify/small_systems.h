// Small systems made by hand, for cases and tests whose answer is known.
//
// Add particles and what joins them, set what the case is about, call finish(system), then run().
#pragma once

#include "step/stepper.h"
#include "system/system.h"

#include <cmath>
#include <random>

namespace ripstop {

inline constexpr double standardGravity = 9.80665; // m/s^2
inline constexpr double airDensity = 1.225; // kg/m^3, of the standard atmosphere at sea level

inline constexpr std::array allIntegrators = [] {
    std::array<Integrator, choiceNames<Integrator>.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = Integrator(i);
    return all;
}();

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

// An empty system with standard gravity along -y.
inline System heavySystem(double timeStep, Integrator integrator = Integrator::SemiImplicitEuler)
{
    System system = emptySystem(timeStep, integrator);
    system.gravity = {0.0, -standardGravity, 0.0};
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
    Spring spring{};
    spring.a = a;
    spring.b = b;
    spring.restLength = restLength;
    spring.stiffness = stiffness;
    spring.damping = damping;
    spring.resists = Resists::Both;
    system.springs.push_back(spring);
    return system.springs.back();
}

inline Rod& addRod(System& system, int a, int b, double restLength, double compliance = 0.0)
{
    Rod rod{};
    rod.a = a;
    rod.b = b;
    rod.restLength = restLength;
    rod.compliance = compliance;
    rod.resists = Resists::Both;
    system.rods.push_back(rod);
    return system.rods.back();
}

inline MaterialAir airOf(AirLaw law, double normalCoefficient, double skinFriction = 0.0)
{
    MaterialAir air;
    air.law = law;
    air.normalCoefficient = normalCoefficient;
    air.skinFriction = skinFriction;
    return air;
}

inline void addPanel(System& system, int a, int b, int c, const MaterialAir& air)
{
    if (system.materialAir.empty() || system.materialAir.back() != air)
        system.materialAir.push_back(air);
    FabricPanel panel{};
    panel.corner = {a, b, c};
    panel.air = int(system.materialAir.size()) - 1;
    system.panels.push_back(panel);
}

inline void addPanel(System& system, int a, int b, int c, AirLaw law, double normalCoefficient,
                     double skinFriction = 0.0)
{
    addPanel(system, a, b, c, airOf(law, normalCoefficient, skinFriction));
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
