// The shape that was designed, beside the one that flies.
//
// The view draws it as a pale ghost, so that one sees how far fabric has moved and stretched under
// load. It is a frame like any other and shares the layout of the design; the stage makes it again
// for each frame that it draws while the ghost is on.
#pragma once

#include "simulation/frame.h"

#include <memory>

namespace ripstop {

// The design where it is to be compared with what it has become. When particles are pinned, it
// stands where it was drawn. When none is, it goes along as a stiff body would: turned and shifted
// so that the sum of the squared distances of all particles is least (Kabsch 1976). `design` comes
// back as it is when no particle of it is left in `now`, or when one of them has no finite place.
std::shared_ptr<const Frame> designGhost(const std::shared_ptr<const Frame>& design,
                                         const Frame& now);

} // namespace ripstop
