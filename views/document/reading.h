#pragma once

#include "scene/id.h"

#include <QString>

namespace ripstop {

struct Frame;

// What an element does at this instant: the speed of a particle, tension and strain of a link, the
// pressure on a panel: "12.3 N · 0.42 %". Empty for what a frame knows nothing of, and for what is
// torn.
QString readingOf(const Frame& frame, Id element);

} // namespace ripstop
