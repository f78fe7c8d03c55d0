// The fabric as one surface: which way its panels face, and how it bends between them.
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

// Unit normals, the mean over the panels at each particle by their area. Particles without a panel
// get any.
//   present   [panels]     panels that count
//   normal    [particles]  out
void smoothNormals(std::span<const Corners> panels, std::span<const std::uint8_t> present,
                   std::span<const Vec3> position, std::span<std::array<float, 3>> normal);

} // namespace ripstop
