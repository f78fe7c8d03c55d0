// What nodes of a glTF file have in their extras that show lines as round tubes (export/tubes.h).
// The lines are in the file as edges as well: who reads it to make fabric of leaves the tubes out.
#pragma once

namespace ripstop {

inline constexpr const char* tubesMark = "ripstopTubes";

} // namespace ripstop
