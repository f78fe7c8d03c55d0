// Wavefront OBJ, read by ourselves: assimp gives each corner of a face a vertex of its own, and
// which vertices of the file were one, double or used by nobody is lost. Whoever wants a report on
// a mesh needs to know.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "shapes/polygon_mesh.h"

#include <string>
#include <string_view>

namespace ripstop {

// Vertices (v, vt), faces (f, with negative indices too), lines (l), objects (o, or g where there
// is no o, or one o whose faces are in several) and names of materials (usemtl) and of the files
// that say their colours (mtllib). Normals, curves and smoothing groups are passed over. Points
// (p), and lines all of which run along faces, are counted as left out. `name` is what messages
// call the file; they say the line.
Result<PolygonMesh> readObj(std::string_view text, const std::string& name,
                            const Progress& progress = {});

// Colours and pictures of the materials of a .mtl file (Kd, map_Kd), given to those of the mesh by
// their name.
void readMtl(std::string_view text, PolygonMesh& mesh);

} // namespace ripstop
