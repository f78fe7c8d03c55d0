// Controls, what is held, pins and cuts, halts; and what frames show of them.
#include "simulation/hand_work.h"

#include "forces/hand_pull.h"
#include "system/system.h"
#include "tearing/cutting.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {

void HandWork::forget()
{
    m_commands.clear();
    m_track.clear();
    m_cuts = 0;
    m_halts = 0;
}

void HandWork::command(const Commands& told, const System& system, RunState& run)
{
    for (std::size_t i = 0; i < system.inputs.size(); ++i)
        if (const auto found = told.find(system.inputs[i].key);
            found != told.end() && std::isfinite(found->second)) {
            const Input& input = system.inputs[i];
            const double value = std::clamp(found->second, -input.limit, input.limit);
            if (value == run.now.inputCommand[i])
                continue;
            run.atStart = false;
            run.now.inputCommand[i] = value;
            m_commands.push_back({run.now.time, input.key, value});
            if (m_inputs)
                m_inputs->push_back({run.now.step, m_commands.back()});
        }
}

void HandWork::note(HandNote::What what, RunState& run)
{
    run.atStart = false;
    if (m_inputs)
        m_inputs->push_back({run.now.step, what});
    m_track.append({run.now.time, std::move(what)});
}

void HandWork::handle(const HandCommands& told, DerivedSystem& system, RunState& run)
{
    handle(told.hands, system, run);
    for (; m_cuts < told.cuts.size(); ++m_cuts)
        cut(told.cuts[m_cuts], system, run);
    for (; m_halts < told.halts; ++m_halts)
        stopMotion(run);
}

void HandWork::handle(const Hands& told, DerivedSystem& system, RunState& run)
{
    Hands& now = run.now.hands;
    if (told == now)
        return;
    if (told.pull != now.pull) {
        now.pull = told.pull;
        note(told.pull ? HandNote::What(*told.pull) : HandNote::LetGo{}, run);
    }
    if (told.fan != now.fan) {
        now.fan = told.fan;
        note(told.fan ? HandNote::What(*told.fan) : HandNote::FanOff{}, run);
    }
    carry(told.carries, run);
    pin(told.pins, system, run);
}

// What is no longer named stays where it has been put.
void HandWork::carry(const std::vector<Carry>& told, RunState& run)
{
    auto& carries = run.now.hands.carries;
    for (const Carry& carry : told) {
        auto held = std::find_if(carries.begin(), carries.end(), [&](const Carry& other) {
            return other.collider == carry.collider;
        });
        if (held == carries.end()) {
            held = carries.insert(carries.end(), {carry.collider, Vec3::Zero()});
            run.now.carried.emplace_back(Vec3::Zero());
        }
        if (held->way == carry.way)
            continue;
        held->way = carry.way;
        note(carry, run);
    }
}

void HandWork::pin(const std::vector<std::uint32_t>& told, DerivedSystem& system, RunState& run)
{
    std::vector<Key>& pins = run.now.hands.pins;
    if (told == pins)
        return;
    const auto has = [](const std::vector<Key>& keys, Key key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    for (const Key key : pins)
        if (!has(told, key))
            note(HandNote::Pin{key, false}, run);
    for (const Key key : told)
        if (!has(pins, key))
            note(HandNote::Pin{key, true}, run);
    pins = told;
    system.deriveAnew(run);
}

void HandWork::cut(const std::shared_ptr<const Cut>& cut, DerivedSystem& system, RunState& run)
{
    note(cut, run);
    if (cutAlong(system.system(), run.now, *cut))
        system.deriveAnew(run);
}

void HandWork::halt(RunState& run)
{
    ++m_halts;
    stopMotion(run);
}

void HandWork::stopMotion(RunState& run)
{
    note(HandNote::Halt{}, run);
    for (auto* motion : {&run.now.velocity, &run.now.drift, &run.now.velocityBefore})
        for (PaddedVec3& velocity : *motion)
            velocity.setZero();
}

void HandWork::fill(Frame& frame, const System& system, const State& state, double h) const
{
    const Hands& hands = state.hands;
    frame.commands = m_commands;
    frame.hands = m_track;
    frame.carries = hands.carries;
    frame.handPins = hands.pins;
    frame.underWay = state.step > 0 || m_cuts > 0 || m_halts > 0 || !hands.pins.empty();
    if (!hands.pull)
        return;
    const HeldGrip held = findGrip(system, hands.pull->grip);
    const HandForce force = handForce(system, state, *hands.pull, held, h);
    if (held.holds())
        frame.held = HeldPoint{force.point, hands.pull->to, force.force.norm(), force.stiffness};
}

} // namespace ripstop
