// The formats that other programs read. Command line, dialog and manual are made from this table. A
// name that no format has gives null, and the caller makes the message.
#pragma once

#include "export/appearance.h"
#include "export/frame_sink.h"
#include "export/series.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

struct ExportFormat
{
    enum class Of { Moment, Series };
    enum class Topology { Free, Constant };     // whether what tears can part the mesh in the file
    enum class Beside { Nothing, Obj, Folder }; // what else is written, with the target's name
    struct Bytes                                // about, for each frame
    {
        int particle;
        int panel;
        int link;
        int probe;
        int frame = 0;     // whatever is in it
        int pair = 0;      // of frames: each has a weight for each
        int roundLine = 0; // beside what a link has
    };

    std::string_view ending; // of the target's name; says which format is meant
    std::string_view label;  // on the screen
    std::string_view note;   // one sentence: what is in it, and who reads it
    Of of;
    Topology topology;
    Beside beside;
    Bytes bytes;
    MomentContent content; // of a moment, and of each file of a sequence
    Result<std::unique_ptr<FrameSink>> (*open)(const std::filesystem::path& target,
                                               const MeshAppearance& appearance); // of other series
    bool isPaced = false; // says no times, and is played at the rate of the range
};

std::span<const ExportFormat> exportFormats();

// The first whose ending the name has; null for none. A name with {frame} means a sequence.
const ExportFormat* formatOf(const std::filesystem::path& target);

// "use .obj, .ply, ...": what to name a target; of formats that can hold one moment, or of all.
enum class EndingsOf { Moments, All };
std::string knownEndings(EndingsOf of);

Result<std::unique_ptr<FrameSink>> openSink(const ExportFormat& format,
                                            const std::filesystem::path& target,
                                            const MeshAppearance& appearance);

// Bytes, about, for as many frames like this one.
double expectedSize(const ExportFormat& format, const Layout& layout,
                    const MeshAppearance& appearance, std::size_t frames);

// What a series of so many frames becomes, the target first, and the materials of OBJ files last; a
// folder stands for what is in it.
std::vector<std::filesystem::path> filesOf(const ExportFormat& format,
                                           const std::filesystem::path& target, std::size_t frames,
                                           const MeshAppearance& appearance);

} // namespace ripstop
