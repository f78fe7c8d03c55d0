// Meshes and series for other programs. All of them are made from frames, and the extension of the
// target chooses the format: .obj, .ply, .vtp (one moment), .pvd (a series of .vtp files in a
// folder of its name beside it, with the arrays strain, tension, panel load and velocity), .csv
// (the probes).
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "run/frame.h"
#include "run/simulation.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>

namespace ripstop {

// With the texture points of a scene's particles, where one is given.
std::optional<Failure> writeObj(const Frame& frame, const std::filesystem::path& file,
                                const Scene* scene = nullptr);
std::optional<Failure> writePly(const Frame& frame, const std::filesystem::path& file);
std::optional<Failure> writeVtp(const Frame& frame, const std::filesystem::path& file);

struct ExportRange
{
    double from = 0.0;            // s
    double to = 0.0;              // s; a format of one moment is taken at this time
    double fps = 25.0;            // frames per simulated second
    const Scene* scene = nullptr; // whose texture points go into OBJ
};

// Runs the simulation from where it is and writes the target. Gone panels and torn links are left
// out of meshes. When cancelled, what was written is removed. When the simulation cannot go on, a
// series or table that ends there is kept and the failure says so; Simulation::trouble() tells this
// case from the others.
std::optional<Failure> exportRun(Simulation& simulation, const ExportRange& range,
                                 const std::filesystem::path& target,
                                 const Progress& progress = {});

} // namespace ripstop
