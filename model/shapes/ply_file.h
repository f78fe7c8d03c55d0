// Polygon files of Stanford (PLY) and of Geomview (OFF), read by ourselves: assimp 5.2 goes on for
// ever in a PLY that is cut off, and crashes on some OFF with wrong indices.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "shapes/polygon_mesh.h"

#include <string>
#include <string_view>

namespace ripstop {

// Ascii and binary of either order. Vertices x, y, z with texture points (s, t or u, v), faces
// (vertex_indices or vertex_index); other elements and properties are passed over, edges are
// counted as stray. `name` is what messages call the file.
Result<PolygonMesh> readPly(std::string_view content, const std::string& name,
                            const Progress& progress = {});

// Ascii, with the word OFF or without; colours behind points and faces are passed over, and points
// of other variants (COFF, NOFF, STOFF) have their first three numbers read.
Result<PolygonMesh> readOff(std::string_view content, const std::string& name,
                            const Progress& progress = {});

} // namespace ripstop
