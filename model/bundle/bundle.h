// A run for a paper or a colleague: what it was made of and what came of it, in one folder or zip.
//
//     README.md            what this is, and the command lines that make all of it again
//     manifest.json        version, hashes of the states at start and end, sums of the files
//     scene.ripstop.json   as it was flown; files/ has those that it names
//     controls.csv         what pilot and hands did, when they did anything
//     run.ripstop-run      the recording, with the hash of each step
//     probes.csv           the probes after each step, when the scene has any
//     curves.svg           the same as a figure
#pragma once

#include "base/progress.h"
#include "bundle/manifest.h"
#include "bundle/temporary_folder.h"
#include "export/frame_source.h"
#include "recording/replay.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

struct BundleOrder
{
    double seconds = 10.0; // s, of the flight
    ControlTrack controls;
    int threads = 1;
    // Puts more files into the folder, like pictures of a window.
    std::function<std::optional<Failure>(const std::filesystem::path&)> decorate;
};

// Flies a scene and writes the bundle: a zip when the target ends with .zip, or else a folder. All
// of it is there in the end or nothing; an older bundle of that name is replaced. A flight that
// stops before its end is kept up to there, and the failure says so; `stopped` then is true.
struct BundleWritten
{
    std::optional<Failure> failure;
    bool stopped = false;
};
BundleWritten writeBundle(const Scene& scene, const BundleOrder& order,
                          const std::filesystem::path& target, const Progress& progress = {});

// The same of a run that was recorded, with all that was changed while it flew. Each step of it is
// computed again.
BundleWritten writeBundle(const std::shared_ptr<const Recording>& recording,
                          const BundleOrder& order, const std::filesystem::path& target,
                          const Progress& progress = {});

struct Bundle
{
    std::shared_ptr<const TemporaryFolder> unpacked; // of a zip
    std::filesystem::path folder;
    Manifest manifest;
    std::vector<std::string> changed; // files that are not as they were written
};

// Folders and zips; no scene and no recording is one.
bool looksLikeBundle(const std::filesystem::path& file);

Result<Bundle> openBundle(const std::filesystem::path& file, const Progress& progress = {});

// Flies it again and compares the hash of each step with those that were recorded.
Result<ReplayOutcome> flyAgain(const Bundle& bundle, int threads, const Progress& progress = {});

} // namespace ripstop
