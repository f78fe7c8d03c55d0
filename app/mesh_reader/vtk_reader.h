// Reads a file of VTK's, *.vtp (PolyData) or *.vtu (UnstructuredGrid), by VTK's own readers: text,
// base64 or appended, compressed or not.
//
// Triangles, quads, polygons and strips become faces. A line becomes one of the mesh where an end
// of it is no corner of a face: lines within the fabric are its own threads, which an import makes
// anew. Of the arrays, texture points, "mass" of points (kg) and "material" of cells are taken.
// Without VTK, the answer is that the format is unknown.
#pragma once

#include "shapes/mesh_answer.h"

#include <functional>
#include <string>

namespace ripstop {

bool isVtkFile(const std::string& file); // by its ending

// The last record of the answer, as answerOfAssimp() gives it.
std::string answerOfVtk(const std::string& file, const std::function<void(double)>& tell);

} // namespace ripstop
