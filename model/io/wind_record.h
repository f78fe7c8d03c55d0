// Winds as anemometers and data loggers have measured them, as rows for Wind::velocities.
//
// The header of the table (base/number_table.h) names its columns, with units in brackets, m/s and
// s unless it says others:
//
//     time (s), speed (m/s)                    blows along +x
//     time (s), speed (km/h), direction (deg)  where it comes from, clockwise as a compass has it;
//                                              turned so that the whole of it goes along +x
//     time (s), x, y, z                        as the scene has its axes: y up
//     time (s), u, v, w                        of a sonic anemometer: ahead, to the left, up
//
// Without a header two columns are time and speed, and four are time, x, y and z. Times rise, and
// are those of the run. Rows with an empty cell, as loggers leave them, are passed over. Failures
// name the file and the line.
#pragma once

#include "base/result.h"
#include "scene/items.h"

#include <filesystem>
#include <string_view>

namespace ripstop {

Result<NumberRows> readWindRecord(std::string_view text, std::string_view name);
Result<NumberRows> windRecordOf(const std::filesystem::path& file);

} // namespace ripstop
