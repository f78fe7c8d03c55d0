#include "recording/run_event.h"

namespace ripstop {
namespace {

using What = HandNote::What;

bool goesOn(const What& what)
{
    return std::holds_alternative<HandPull>(what) || std::holds_alternative<Carry>(what)
           || std::holds_alternative<Airflow>(what);
}

} // namespace

InputKind kindOf(const RunInput& input)
{
    if (const auto* command = std::get_if<ControlCommand>(&input.what))
        return {input.what.index(), command->control};
    const What* hand = std::get_if<What>(&input.what);
    return {input.what.index(), hand ? hand->index() : 0};
}

bool isEvent(const RunInput& input, const InputKind& before)
{
    const What* hand = std::get_if<What>(&input.what);
    const bool repeats = hand ? goesOn(*hand) : std::holds_alternative<ControlCommand>(input.what);
    return !repeats || kindOf(input) != before;
}

RunEvent eventOf(const RunInput& input, double time)
{
    if (const auto* command = std::get_if<ControlCommand>(&input.what))
        return {RunEvent::Kind::Control, input.step, time, command->control, 1};
    const bool hand = std::holds_alternative<What>(input.what);
    return {hand ? RunEvent::Kind::Hand : RunEvent::Kind::Edit, input.step, time, 0, 1};
}

} // namespace ripstop
