// The places of a run that are loaded most for what they bear, as a CSV file in SI units, for
// spreadsheets. The failure says why the file could not be written.
#pragma once

#include "base/result.h"
#include "scene/scene.h"
#include "simulation/frame.h"

#include <filesystem>

namespace ripstop {

// A table with a row for each place, first those of the last moment, then those of the run, the
// worst first, and at the end those that broke first, in that order:
// "of,rank,time (s),kind,element,part,load,strength,unit,margin,x (m),y (m),z (m),torn,shortfall".
// `of` is moment, run or first to break; the element is the id of a link or panel; a part that is
// no longer in the scene is an empty cell; torn is 1 of what broke under this load; shortfall is
// how much higher it may have been (simulation/snatch_loads.h). What broke by a rule that knows no
// strength has empty cells for that and the margin.
std::optional<Failure> writeLoads(const Scene& scene, const Frame& last,
                                  const std::filesystem::path& file);

} // namespace ripstop
