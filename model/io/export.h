// Meshes and series for other programs. All of them are made from frames, and the extension of the
// target chooses the format: .obj, .ply, .vtp (one moment), .pvd (a series of .vtp files in a
// folder of its name beside it, with the arrays strain, tension, panel load and velocity), .csv
// (the probes).
#pragma once

#include "base/result.h"
#include "run/frame.h"
#include "run/simulation.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace ripstop {

std::optional<Failure> writeObj(const Frame& frame, const std::filesystem::path& file);
std::optional<Failure> writePly(const Frame& frame, const std::filesystem::path& file);
std::optional<Failure> writeVtp(const Frame& frame, const std::filesystem::path& file);

struct ExportRange
{
    double from = 0.0; // s
    double to = 0.0;   // s; a format of one moment is taken at this time
    double fps = 25.0; // frames per simulated second
};

// Called with the share that is done, 0 to 1; false cancels, and what was written is removed.
using Progress = std::function<bool(double)>;

// Runs the simulation from where it is and writes the target. Gone panels and torn links are left
// out of meshes. When the simulation cannot go on, a series or table that ends there is kept and
// the failure says so; Simulation::trouble() tells this case from the others.
std::optional<Failure> exportRun(Simulation& simulation, const ExportRange& range,
                                 const std::filesystem::path& target,
                                 const Progress& progress = {});

} // namespace ripstop
