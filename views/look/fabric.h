// The fabric as one surface: which way its panels face, and how it bends between them.
//
// The panel layer asks for the facing once per layout and for the normals with each frame, so that
// light falls smoothly over the panels. Both are plain loops over arrays; they know neither VTK nor
// Qt and keep nothing.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ripstop {

using Corners = std::array<int, 3>; // particle indices

// A corner of a panel on the cloth: m along the weft, m along the warp, the share of light that
// comes through, m between the threads of a ripstop.
using ClothPoint = std::array<float, 4>;

// The panels, turned so that neighbours face the same way wherever the surface allows it: authors
// and mesh files need not wind them alike. Edges with three or more panels join nothing.
std::vector<Corners> facingAlike(std::span<const Corners> panels);

// Unit normals: at each particle the mean over its panels, weighted by their area. A particle
// without a panel gets the upward one.
//     present   [panels]     1 for panels that count
//     position  [particles]  m
//     normal    [particles]  out, unit
void smoothNormals(std::span<const Corners> panels, std::span<const std::uint8_t> present,
                   std::span<const Vec3> position, std::span<std::array<float, 3>> normal);

// Lays the panels, each flat by itself, side by side on one sheet of cloth: each is shifted, and
// turned by half a turn if need be, until the middle of a side lies where its neighbour has it. On
// what unrolls, corners that are the same particle come together; elsewhere, and where the cloth is
// sewn on the bias, they part.
//     panels  [panels]     facing alike
//     points  [panels][3]  of the corners, with axes that turn as the panel faces
void laySideBySide(std::span<const Corners> panels, std::span<std::array<ClothPoint, 3>> points);

// The fewest vertices that give each panel its corners on the cloth: a particle has one for each
// point of the cloth that meets there.
struct ClothVertices
{
    std::vector<int> particle;     // [vertices]
    std::vector<ClothPoint> point; // [vertices]
    std::vector<Corners> corners;  // [panels] vertices
};
ClothVertices clothVertices(std::span<const Corners> panels,
                            std::span<const std::array<ClothPoint, 3>> points,
                            std::size_t particles);

} // namespace ripstop
