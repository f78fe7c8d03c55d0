#pragma once

#include "author/condition.h"
#include "run/frame.h"

#include <memory>

namespace ripstop {

// What conditions can ask of an instant: where things are, how fast, how stretched, how loaded.
// The gauge keeps the frame; without one it measures nothing.
Gauge gaugeOf(std::shared_ptr<const Frame> frame);

} // namespace ripstop
