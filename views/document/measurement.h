// What conditions and views ask of an instant: where things are, how fast, how stretched, how
// loaded. A frame does not change, so any thread may ask; texts are in the language of the window.
#pragma once

#include "select/condition.h"
#include "simulation/frame.h"

#include <QString>

#include <memory>

namespace ripstop {

// The measurement that conditions read. It keeps the frame; without one it measures nothing.
Measurement measurementOf(std::shared_ptr<const Frame> frame);

// What an element does at this instant, in three digits: the speed of a particle, tension and
// strain of a link, the load on a panel: "12.3 N · 0.42 %". Empty for what the frame does not know
// and for what is torn.
QString readingOf(const Frame& frame, Id element);

} // namespace ripstop
