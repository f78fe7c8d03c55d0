// A mesh made ready to become fabric: vertices that lie on each other joined, faces that are none
// left out, all of them wound the same way, polygons split into triangles.
#pragma once

#include "author/mesh_report.h"
#include "base/progress.h"
#include "base/result.h"
#include "shapes/polygon_mesh.h"

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
std::vector<PolygonMesh> byObject(const PolygonMesh& mesh);

// The point of each point that is joined with one before it, or its own index (see repaired()).
std::vector<int> welded(const std::vector<Vec3>& points, double tolerance);

// Splits one polygon into triangles, point indices: a convex quad along its shorter diagonal,
// others by cutting ears (Meisters 1975), so that hollow ones keep their area.
void splitPolygon(std::span<const int> corners, const std::vector<Vec3>& points,
                  std::vector<std::array<int, 3>>& triangles);

// Twice the area vector of a polygon (Newell), m^2.
Vec3 doubleArea(std::span<const int> corners, const std::vector<Vec3>& points);

// Whether a quad has no hollow or straight corner, seen along its area vector.
bool isConvexQuad(std::span<const int> corners, const std::vector<Vec3>& points);

} // namespace ripstop
