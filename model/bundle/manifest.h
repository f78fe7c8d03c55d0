// What a bundle says about itself, in manifest.json. Times are in seconds; hashes and sums are
// texts. A manifest that cannot be read is a failure that names the file.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ripstop {

namespace bundled { // names of the files
inline constexpr const char* readme = "README.md";
inline constexpr const char* manifest = "manifest.json";
inline constexpr const char* scene = "scene.ripstop.json";
inline constexpr const char* controls = "controls.csv";
inline constexpr const char* recording = "run.ripstop-run";
inline constexpr const char* probes = "probes.csv";
inline constexpr const char* curves = "curves.svg";
inline constexpr const char* files = "files"; // a folder, of those that the scene names
} // namespace bundled

struct Manifest
{
    enum class From { Scene, Recording }; // what it is flown from again

    struct File
    {
        std::uintmax_t bytes = 0;
        std::string sum; // empty for the recording, which has its own
    };

    std::string program; // that wrote it
    std::string title;   // of the scene
    From from = From::Scene;
    double begin = 0.0; // s
    double end = 0.0;   // s
    double timeStep = 0.0;
    std::int64_t steps = 0;
    std::string hashAtStart;
    std::string hashAtEnd;
    std::string stopped; // why the flight ended early; empty when it did not
    std::vector<std::string> commands;
    std::map<std::string, File> files; // by name
};

std::string manifestText(const Manifest& manifest);

// Of the bundle in a folder.
Result<Manifest> readManifest(const std::filesystem::path& folder);

// All files under the folder but the manifest itself.
Result<std::map<std::string, Manifest::File>> filesIn(const std::filesystem::path& folder);

} // namespace ripstop
