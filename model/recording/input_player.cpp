#include "recording/input_player.h"

#include "compile/compile.h"
#include "recording/recording.h"
#include "simulation/simulation.h"

#include <algorithm>

namespace ripstop {

InputPlayer::InputPlayer(const Recording& recording, const State& start)
    : m_recording(recording)
    , m_inputs(recording.inputs())
{
    const auto first =
        std::partition_point(m_inputs.begin(), m_inputs.end(),
                             [&](const RunInput& input) { return input.step < start.step; });
    m_next = std::size_t(first - m_inputs.begin());
    m_hands.hands = start.hands;
}

std::optional<Failure> InputPlayer::giveTo(Simulation& simulation)
{
    for (; m_next < m_inputs.size() && m_inputs[m_next].step <= simulation.state().step; ++m_next)
        if (auto failure = give(m_inputs[m_next], simulation))
            return failure;
    return std::nullopt;
}

std::optional<Failure> InputPlayer::give(const RunInput& input, Simulation& simulation)
{
    if (const auto* command = std::get_if<ControlCommand>(&input.what)) {
        simulation.command({{command->control, command->value}});
    } else if (const auto* hand = std::get_if<HandNote::What>(&input.what)) {
        add(*hand, m_hands);
        simulation.handle(m_hands);
    } else {
        const int number = std::get<DesignChange>(input.what).number;
        auto system = compile(m_recording.design(number).scene(), std::uint64_t(number) + 1,
                              simulation.system().run);
        if (!system)
            return system.failure();
        simulation.load(std::move(*system));
    }
    return std::nullopt;
}

} // namespace ripstop
