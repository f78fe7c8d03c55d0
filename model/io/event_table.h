// The events of a run as a CSV file, with times in seconds. The failure says why the file could not
// be written.
#pragma once

#include "base/result.h"
#include "recording/run_event.h"
#include "scene/scene.h"

#include <filesystem>
#include <span>
#include <string>

namespace ripstop {

// What an event is about, by name where it has one: "canopy, ground", "link 17", "".
std::string subjectOf(const RunEvent& event, const Scene& scene);

// A table with a row for each event, in order of time: "time (s),step,event,subject,count".
std::optional<Failure> writeEvents(const Scene& scene, std::span<const RunEvent> events,
                                   const std::filesystem::path& file);

} // namespace ripstop
