// A mesh made ready to become fabric: vertices that lie on each other joined, faces that are none
// left out, all of them wound the same way, polygons split into triangles.
#pragma once

#include "author/mesh_report.h"
#include "base/progress.h"
#include "base/result.h"
#include "shapes/polygon_mesh.h"
#include "shapes/polygon_split.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ripstop {

struct MeshEdge
{
    int a; // point indices, a < b
    int b;
    std::array<int, 2> faces; // the first two; -1 for none
    int faceCount;
};

struct RepairedMesh
{
    PolygonMesh mesh;                               // m, y up; no corner twice in a face
    std::vector<PolygonMesh::TexturePoint> texture; // [points], or empty
    std::vector<MeshEdge> edges;                    // of the polygons, ascending by a, then b
    std::vector<std::array<int, 3>> triangles;      // point indices
    std::vector<int> faceOf;                        // [triangles]
    MeshReport report;
};

// `mesh` is in metres with y up. Points nearer to each other than `weldTolerance` (m, 0 or more)
// are joined, each to the nearest of those before it, so that chains of points do not collapse.
// Windings follow the larger part of each piece, or point outwards where it is closed. Fails only
// when nothing is left, or cancelled.
Result<RepairedMesh> repaired(PolygonMesh mesh, double weldTolerance,
                              const Progress& progress = {});

// Each object as a mesh of its own, without what it does not use; those without faces are left out.
// One that is alone stays as it is.
std::vector<PolygonMesh> byObject(const PolygonMesh& mesh);

} // namespace ripstop
