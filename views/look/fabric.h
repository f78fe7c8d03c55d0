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

} // namespace ripstop
