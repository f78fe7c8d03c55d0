// The shape that was designed, beside the one that flies.
#pragma once

#include "run/frame.h"

#include <memory>

namespace ripstop {

// The design where it is to be compared with what it has become. With pinned particles it stands
// where it was drawn. Without, it goes along as a stiff body would: turned and shifted so that the
// squares of the distances of all particles sum up to the least (Kabsch 1976).
std::shared_ptr<const Frame> designGhost(const std::shared_ptr<const Frame>& design,
                                         const Frame& now);

} // namespace ripstop
