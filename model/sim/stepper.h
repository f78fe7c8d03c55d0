#pragma once

#include "sim/system.h"

namespace ripstop {

// Advances a State by one time step of its System. Holds scratch arrays only: two steppers given
// the same system and state do exactly the same, whatever `threads` is.
class Stepper
{
public:
    explicit Stepper(int threads = 1)
        : m_threads(threads)
    {}

    void step(const System& system, State& state);

private:
    void moveInputs(const System& system, State& state, double h);
    void addForces(const System& system, const State& state);
    void move(const System& system, State& state, double h);
    void project(const System& system, State& state, double h);
    void finishMotion(const System& system, State& state, double h);

    int m_threads;
    int m_substep = 0;
    std::vector<Vec3> m_force;        // [particles] N
    std::vector<Vec3> m_springForce;  // [springs] N, on `a`
    std::vector<Vec3> m_panelForce;   // [panels] N
    std::vector<Vec3> m_predicted;    // [particles] m, before projection
    std::vector<Vec3> m_acceleration; // [particles] m/s^2, of the forces alone
    std::vector<Vec3> m_correction;   // [particles] m
    std::vector<double> m_lambda;     // [rods] kg m, multipliers of this substep
    std::vector<double> m_restLength; // [rods] m, with the weight shifts of now
};

} // namespace ripstop
