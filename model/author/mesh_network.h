// The links of a fabric that is drawn as a mesh, by what they stand for.
//
// Structural links run along the edges. An edge stands for a strip of fabric, whose width is an
// area over the edge's length:
// - In a convex quad, as in the cells of a woven sheet, half of the cell's area from either side:
//   width 2 (A/2) / L is the height of the cell (link_stiffness.h). The squares of the aspects of
//   cells that differ are taken by their areas.
// - In a triangle all of its area, from either side: Van Gelder 1998, k = E t (A + A') / L^2.
//   Three directions of threads resist shear too, with G = 3/8 E (equilateral triangles).
// Polygons that are not convex or have more corners are taken as the triangles that they are split
// into.
//
// Shear links are both diagonals of a quad, with biasWidth(). Across the edge between two triangles
// there is one, between the corners that lie opposite. It is to its pair of triangles what an edge
// is to its own, so three families of them resist shear with 3/8 of their stiffness. For the
// fabric's own G t they get 8/3 of it: width 8/3 (A + A') / D.
//
// Bend links skip one particle: over two edges that go on into each other, the straightest first,
// where they turn by less than 45 degrees (Provot 1995, for any mesh).
#pragma once

#include "author/mesh_repair.h"
#include "builders/network.h"

namespace ripstop {

enum class LinkStyle { None, Springs, Rods };
std::string_view linkStyleName(LinkStyle style); // "none", "springs", "rods"

struct Weave
{
    LinkStyle structural = LinkStyle::Rods;
    LinkStyle shear = LinkStyle::Rods;
    LinkStyle bend = LinkStyle::None;
};

// Whether the face resists as a cell of woven fabric does; others do as triangles.
bool isCell(const PolygonMesh& mesh, std::size_t face);

struct WeaveMaterials
{
    std::vector<Id> fabric;   // of panels, structural and shear links, by the material of the file;
                              // one id is for all
    Id bend;                  // of bend links
    Id line{};                // of the lines of the file, where there are some
    double lineDensity = 0.0; // kg/m, of those

    Id of(int fileMaterial) const
    {
        return fabric[fabric.size() == 1 ? 0 : std::size_t(fileMaterial)];
    }
};

// [triangles] A way along which the warp runs on each, up the texture of its face: on a seam of the
// texture its own, where the particles there have that of another face.
std::vector<Vec3> warpsOf(const RepairedMesh& mesh);

// Degrees, of the warps from the nearest edge of their face, along which threads run, as the mean
// over the triangles; 0 of a mesh without texture.
double warpsOffThreads(const RepairedMesh& mesh);

// Adds particles, links and panels of the mesh, and the mass of the fabric (density in kg/m^2) and
// of lines; where the file says the masses of points, they hold instead. Lines only pull.
// Panels come in the order of the triangles. Answers false when cancelled.
[[nodiscard]] bool weaveInto(Network& network, const RepairedMesh& mesh, const Weave& weave,
                             const WeaveMaterials& materials, double density,
                             const Progress& progress = {});

} // namespace ripstop
