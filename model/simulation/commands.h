// Where the controls are told to go. A plain value: the window makes it, the thread of the runner
// takes it (runner.h), and whoever steps a simulation of his own may as well.
#pragma once

#include <cstdint>
#include <map>

namespace ripstop {

// m, by the id of the control. Controls that are not named keep what they were told before.
using Commands = std::map<std::uint32_t, double>;

} // namespace ripstop
