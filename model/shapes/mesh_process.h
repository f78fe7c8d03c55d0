// Reading by assimp, in a process of its own: a file that the library crashes on, or that asks for
// all memory, ends the program ripstop-mesh-reader (app/mesh_reader) and not this one.
//
// The program stands beside the one that runs, or in the folder bin beside its folder, as for
// tests. It bounds itself by the limits below before it opens the file.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "shapes/polygon_mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace ripstop {

// What reading a file may take. The files that a mesh names, as glTF names its buffers, count with
// it.
struct ReadLimits
{
    static constexpr std::uint64_t mostBytes = std::uint64_t(1) << 30;    // of files
    static constexpr std::uint64_t memoryAtOnce = std::uint64_t(1) << 29; // bytes
    static constexpr std::uint64_t memoryPerByte = 64;                    // bytes
    static constexpr std::uint64_t secondsAtOnce = 60;                    // of a processor
    static constexpr std::uint64_t bytesPerSecond = std::uint64_t(1) << 19;
};

// As the file has it; formats that say their unit come in metres. The message of a failure is a
// whole sentence that names the file. Cancelling ends the process at once.
Result<PolygonMesh> readInOwnProcess(const std::filesystem::path& file, const Progress& progress);

} // namespace ripstop
