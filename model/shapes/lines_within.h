// Lines of a mesh file that run along its faces: both ends are corners of one, so that the line is
// a side of it or crosses it. Fabric has threads or panels there already, and a line between two
// points of the fabric that no face has, as a spreader or the leg of a bridle, is none of them.
#pragma once

#include "shapes/polygon_mesh.h"

#include <cstdint>
#include <vector>

namespace ripstop {

// [lines] 1 for those within a face. Indices of lines and faces have to be those of points.
std::vector<std::uint8_t> linesWithinFaces(const PolygonMesh& mesh);

} // namespace ripstop
