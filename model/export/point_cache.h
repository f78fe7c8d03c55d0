// Point caches: the places of the vertices of one mesh over time, for Blender (Mesh Cache), Maya
// and others. The mesh itself comes beside the cache, as an OBJ of the same name.
//
// PC2 (Autodesk 3ds Max): "POINTCACHE2", an end mark, version 1, the number of points, the first
// frame and the step between samples (float), the number of samples; then single precision, low
// byte first. MDD (NewTek LightWave): the numbers of frames and points, the time of each frame in
// seconds; then single precision, all of it high byte first.
#pragma once

#include "export/appearance.h"
#include "export/frame_sink.h"

#include <filesystem>
#include <memory>

namespace ripstop {

Result<std::unique_ptr<FrameSink>> pc2Sink(const std::filesystem::path& target,
                                           const MeshAppearance& appearance);
Result<std::unique_ptr<FrameSink>> mddSink(const std::filesystem::path& target,
                                           const MeshAppearance& appearance);

} // namespace ripstop
