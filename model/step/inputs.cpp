// What hands move in a substep: inputs, the pins among their targets, and what is carried; then the
// rest lengths that a shifted weight gives its rods.
#include "step/inputs.h"

#include "base/portable_math.h"

#include <algorithm>

namespace ripstop {

bool moveInputs(const System& system, State& state, double h)
{
    bool changed = false;
    for (std::size_t i = 0; i < system.inputs.size(); ++i) {
        const Input& input = system.inputs[i];
        double& command = state.inputCommand[i];
        command = std::clamp(command + input.automaticRate * h, -input.limit, input.limit);

        const double most = input.rate * h;
        const double change = std::clamp(command - state.inputValue[i], -most, most);
        state.inputValue[i] += change;
        changed |= change != 0.0;
        if (input.kind == ControlKind::Move && change != 0.0)
            for (const int target : input.targets)
                state.position[std::size_t(target)] += change * input.axis;
    }
    return changed;
}

void PinWays::reserve(const System& system)
{
    std::size_t targets = 0;
    for (const Input& input : system.inputs)
        targets += input.targets.size();
    m_pins.reserve(targets);
}

void PinWays::note(const System& system, const State& state)
{
    m_pins.clear();
    for (const Input& input : system.inputs)
        if (input.kind == ControlKind::Move)
            for (const int target : input.targets)
                if (const auto p = std::size_t(target); system.inverseMass[p] == 0.0)
                    m_pins.push_back({p, state.position[p]});
}

void PinWays::giveVelocities(State& state, double h) const
{
    for (const auto& [particle, place] : m_pins)
        state.velocity[particle] = (state.position[particle] - place) / h;
}

void PinWays::lookBack(State& state, std::span<PaddedVec3> before, double h) const
{
    giveVelocities(state, h);
    for (const auto& [particle, place] : m_pins) {
        before[particle] = place;
        state.drift[particle] = state.velocity[particle];
    }
}

void PinWays::forget(State& state, std::span<PaddedVec3> before) const
{
    for (const Pin& pin : m_pins) {
        before[pin.particle] = state.position[pin.particle];
        state.drift[pin.particle] = state.velocityBefore[pin.particle] =
            state.velocity[pin.particle];
    }
}

void moveCarried(State& state, double h)
{
    constexpr double lag = 0.05;          // s
    constexpr double highestSpeed = 10.0; // m/s
    constexpr double arrived = 1e-9;      // m
    if (state.carried.empty())
        return;
    const double share = 1.0 - portableExp(-h / lag);
    for (std::size_t i = 0; i < state.carried.size(); ++i) {
        const Vec3 left = state.hands.carries[i].way - state.carried[i];
        const double distance = left.norm();
        if (distance <= arrived)
            state.carried[i] = state.hands.carries[i].way;
        else
            state.carried[i] += std::min(share, highestSpeed * h / distance) * left;
    }
}

void fillRestLengths(const System& system, const State& state, std::span<double> restLength)
{
    for (std::size_t i = 0; i < system.rods.size(); ++i)
        restLength[i] = system.rods[i].restLength;
    shiftRestLengths(system, state, restLength);
}

void shiftRestLengths(const System& system, const State& state, std::span<double> restLength)
{
    for (const ShiftedRod& shifted : system.shiftedRods) {
        Vec3 shift = Vec3::Zero();
        for (std::size_t i = 0; i < system.inputs.size(); ++i) {
            const Input& input = system.inputs[i];
            const auto& targets = input.targets;
            if (input.kind == ControlKind::WeightShift
                && std::find(targets.begin(), targets.end(), shifted.weight) != targets.end())
                shift += state.inputValue[i] * input.axis;
        }
        const auto rod = std::size_t(shifted.rod);
        const double designed = shifted.anchor.norm();
        restLength[rod] = system.rods[rod].restLength;
        if (designed > 0.0)
            restLength[rod] *= (shifted.anchor - shift).norm() / designed;
    }
}

} // namespace ripstop
