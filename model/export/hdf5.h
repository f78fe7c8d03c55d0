// A series as one HDF5 file, for Python, Matlab and Julia: arrays over all frames, compressed,
// which are read by stretches and without loading the rest.
//
//     /time [frames] s, /step [frames], /probes/NAME [frames]
//     /mesh0/...  of the frames with the same particles, links and panels; where a tear splits the
//                 mesh, or an edit changes it, /mesh1 begins; its attribute first_frame says where
//         time [f], particles/{id, position, velocity}, links/{id, ends, strain, tension, torn},
//         panels/{id, corners, load, gone}, and where panels carry the pull, panels/{strain,
//         tension, state}
//
// Each dataset has its unit as the attribute "unit". Numbers are those of the frames, to the bit.
#pragma once

#include "export/appearance.h"
#include "export/frame_sink.h"

#include <filesystem>
#include <memory>

namespace ripstop {

// Fails where the program was built without the library.
Result<std::unique_ptr<FrameSink>> hdf5Sink(const std::filesystem::path& target,
                                            const MeshAppearance& appearance);

} // namespace ripstop
