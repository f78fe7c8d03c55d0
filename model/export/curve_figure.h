// Exports the curves of the probes over time as an SVG figure. It fails where the scene has no
// probes.
#pragma once

#include "export/appearance.h"
#include "export/frame_sink.h"

#include <filesystem>
#include <memory>

namespace ripstop {

// The curves of the probes over time as a figure, SVG: a panel for each unit, times of tears as
// marks. Long curves are thinned for drawing so that no peak is lost.
Result<std::unique_ptr<FrameSink>> figureSink(const std::filesystem::path& target,
                                              const MeshAppearance& appearance);

} // namespace ripstop
