// Exports a series as glTF 2.0 (Khronos). Frames come one after the other through the sink; files
// are written when the series is finished.
#pragma once

#include "export/appearance.h"
#include "export/frame_sink.h"

#include <filesystem>
#include <memory>

namespace ripstop {

// glTF 2.0, as .glb in one file or .gltf as text. The first frame is the mesh, each later one a
// morph target, and an animation goes from one to the next in a straight line, in simulated time.
// Lines are edges of that mesh, and round ones also tubes in a mesh of their own (tubes.h).
// One frame alone is a mesh at rest, with normals; moving ones have none, since a viewer then
// shades each face as it stands (glTF 2.0, 3.7.2.1).
Result<std::unique_ptr<FrameSink>> gltfSink(const std::filesystem::path& target,
                                            const MeshAppearance& appearance);

} // namespace ripstop
