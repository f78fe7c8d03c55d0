// Points of a mesh that hang on a side of a face without being a corner of it, as where a coarse
// panel meets a fine one or a keel a sail: fabric would be open there, and load its whole seam at
// the few corners that both share. The repair of a mesh (mesh_repair.cpp) calls it once points
// that lie on each other are one.
#pragma once

#include "author/mesh_report.h"
#include "shapes/polygon_mesh.h"

namespace ripstop {

// Makes such points corners of the faces that have the side, with the texture that these have
// there, and reports them. They lie within `tolerance` of it, m, and it or they lie on a rim;
// nothing hangs by a tolerance of 0.
void joinHangingPoints(PolygonMesh& mesh, double tolerance, MeshReport& report);

} // namespace ripstop
