// Series of files, one for each frame, and the table of the probes. The sinks write through
// OutputFiles, so that a series is there whole or not at all.
#pragma once

#include "export/appearance.h"
#include "export/frame_sink.h"

#include <filesystem>
#include <memory>
#include <string>

namespace ripstop {

using MomentContent = Result<std::string> (*)(const Frame& frame, const MeshAppearance& appearance);

// What a target's name has where the number of the frame goes: sail_{frame}.obj.
constexpr std::string_view framePlaceholder = "{frame}";

// The file of a frame: 0000, 0001, ...
std::filesystem::path fileOfFrame(const std::filesystem::path& target, std::size_t number);

Result<std::unique_ptr<FrameSink>> sequenceSink(const std::filesystem::path& target,
                                                const MeshAppearance& appearance,
                                                MomentContent content);

// For ParaView: the index kite.pvd, and the moments kite/kite_0000.vtp, ...
Result<std::unique_ptr<FrameSink>> pvdSink(const std::filesystem::path& target,
                                           const MeshAppearance& appearance);

// The probes, a row for each frame.
Result<std::unique_ptr<FrameSink>> tableSink(const std::filesystem::path& target,
                                             const MeshAppearance& appearance);

} // namespace ripstop
