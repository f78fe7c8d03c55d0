// The flights that are compared as ghosts in the view, each in the colour of its curve: over each
// other, or side by side. Only the window's thread calls it.
#pragma once

#include "document/recordings.h"

namespace ripstop {

class FlightCurves;

//   current  what the timeline shows, which is no ghost of itself
std::vector<Recordings::Ghost> ghostsOf(const FlightCurves& compared,
                                        const std::shared_ptr<Recording>& current);

} // namespace ripstop
