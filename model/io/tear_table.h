// The breaks of a run as a CSV file, in SI units, for spreadsheets. The failure says why the file
// could not be written.
#pragma once

#include "base/result.h"
#include "scene/scene.h"
#include "simulation/frame.h"

#include <filesystem>

namespace ripstop {

// A table with a row for each break, in order of time:
// "time (s),element,part,strain,force (N),energy (J),x (m),y (m),z (m),tension (N/m),moment (N m),
// event". The element is the id of the link or the panel; a part that is no longer in the scene is
// an empty cell, and so are the two loads that the element did not tear by. The event is the
// number, from 1 on, of that which the break is part of (run/tear_events.h).
std::optional<Failure> writeTears(const Scene& scene, const Frame& frame,
                                  const std::filesystem::path& file);

} // namespace ripstop
