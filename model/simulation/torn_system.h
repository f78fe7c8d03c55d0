// What tears have made of a system, for who wants to make a design of it (pose.h). Frames name it
// and views never look into it.
#pragma once

#include "system/system.h"

#include <memory>
#include <vector>

namespace ripstop {

struct TornSystem
{
    std::shared_ptr<const System> system;
    std::vector<Split> splits;
};

} // namespace ripstop
