// Names that tell the probes of a scene apart, where its author gave several the same one.
#pragma once

#include "simulation/frame.h"

#include <string>
#include <vector>

namespace ripstop {

// The name of each probe; the second "height" is "height (2)".
std::vector<std::string> distinctNames(const std::vector<Layout::Probe>& probes);

} // namespace ripstop
