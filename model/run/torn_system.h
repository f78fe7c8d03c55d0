#pragma once

#include "system/system.h"

#include <memory>

namespace ripstop {

// What tears have made of a system, for who wants to make a design of it.
struct TornSystem
{
    std::shared_ptr<const System> system;
    std::vector<Split> splits;
};

} // namespace ripstop
