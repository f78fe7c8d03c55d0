// What a run was told from outside: designs, commands and what hands did, each with its step. Same
// start and same inputs, same bits. Values that may go anywhere.
#pragma once

#include "simulation/frame.h"

#include <cstdint>
#include <variant>

namespace ripstop {

struct DesignChange
{
    int number = 0; // among the designs of a recording

    friend bool operator==(const DesignChange&, const DesignChange&) = default;
};

// Taken at the boundary before the step that follows `step`, in the order of a list.
struct RunInput
{
    std::int64_t step = 0; // time steps since the start
    std::variant<DesignChange, ControlCommand, HandNote::What> what;
};

} // namespace ripstop
