// The number that names a thing of a scene. Every reference between things is an id, in files,
// edits, selections and frames; inside the engine there are indices instead.
#pragma once

#include <cstdint>

namespace ripstop {

// Names one item or one element (particle, link, panel) of a scene. Items and elements draw from
// the same counter and a number is never used twice, so an id says which thing it is by itself.
enum class Id : std::uint32_t {};

inline constexpr Id noId{0};
inline constexpr Id settingsId{0xffffffff}; // the settings are always there and cannot be removed

} // namespace ripstop
