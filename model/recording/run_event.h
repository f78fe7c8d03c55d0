// What happened in a run that one may want to find again: tears, what it was told, contact, slack
// lines. Values that go from the thread of the simulation (event_watch.h) to views, files and
// tables.
#pragma once

#include "simulation/run_input.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace ripstop {

struct RunEvent
{
    enum class Kind { Tear, Control, Hand, Edit, Stopped, Contact, LiftOff, Slack, Taut };
    Kind kind = Kind::Tear;
    std::int64_t step = 0;
    double time = 0.0;      // s
    std::uint32_t what = 0; // id of the link or panel that tore, the control that was moved, the
                            // part that touches, the first link of the line; 0 for none
    int count = 1;          // links and panels that tore in the step, lines that changed
    std::uint32_t with = 0; // id of the collider that is touched

    friend bool operator==(const RunEvent&, const RunEvent&) = default;
};

inline constexpr std::array<std::string_view, 9> runEventNames{
    "tear", "control", "hand", "edit", "stopped", "contact", "lift_off", "slack", "taut"};

// What an input is about: which control, which thing that hands do.
struct InputKind
{
    std::size_t what = std::variant_npos;
    std::size_t detail = 0;

    friend bool operator==(const InputKind&, const InputKind&) = default;
};
InputKind kindOf(const RunInput& input);

// A pull or a fan that goes on moving is no event, nor is a control that is held.
bool isEvent(const RunInput& input, const InputKind& before);
RunEvent eventOf(const RunInput& input, double time);

} // namespace ripstop
