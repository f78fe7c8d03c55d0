// A flight for other programs: writes what a simulation or a recording passes through. Times are in
// seconds of the simulation. Failures are sentences; one thread at a time uses the source.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "export/appearance.h"
#include "export/frame_sink.h"
#include "export/frame_source.h"

#include <filesystem>
#include <optional>

namespace ripstop {

struct ExportRange
{
    double from = 0.0; // s
    double to = 0.0;   // s; a format of one moment is taken at this time
    double fps = 25.0; // frames per simulated second
    // At a rate above that of the steps a moment is taken once, or as often as it is asked for, by
    // what says no times and is played at the rate: a film is as long as it is meant to be.
    bool repeats = false;
};

// How many frames the range asks for, and how many there are of steps of `timeStep`, s.
std::size_t frameCount(const ExportRange& range);
std::size_t frameCount(const ExportRange& range, double timeStep);

// Writes one frame as the name of the target says. The file is the old one or the new one, whole.
std::optional<Failure> writeMoment(const Frame& frame, const MeshAppearance& appearance,
                                   const std::filesystem::path& target);

// Writes the target, whose name says the format (export/format.h). Gone panels and torn links are
// left out of meshes. When cancelled, nothing is left of what was written. When the source ends
// before the range does, a series that ends there is kept and the failure says so.
std::optional<Failure> exportRun(FrameSource& source, const MeshAppearance& appearance,
                                 const ExportRange& range, const std::filesystem::path& target,
                                 const Progress& progress = {});

// The same for any series.
std::optional<Failure> exportSeries(FrameSource& source, const ExportRange& range, FrameSink& sink,
                                    const Progress& progress = {});

} // namespace ripstop
