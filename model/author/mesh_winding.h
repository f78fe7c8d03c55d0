// Edges of a mesh, its pieces, and which way its faces are wound. The repair of a mesh
// (mesh_repair.cpp) calls it after double points and faces are gone, since both would look like
// edges of the wrong count.
#pragma once

#include "author/mesh_repair.h"

namespace ripstop {

// The edges of all faces, each once, ascending by a, then b.
std::vector<MeshEdge> edgesOf(const PolygonMesh& mesh);

// Winds faces that share an edge alike, as the larger part (by area) of a piece is, and closed
// pieces outwards; reports what edges and pieces are like. Corners of a face that is turned over
// keep its first one. Edges of more than two faces are borders to this.
void unifyWindings(PolygonMesh& mesh, const std::vector<MeshEdge>& edges, MeshReport& report);

} // namespace ripstop
