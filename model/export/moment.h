// One moment as a file for other programs: its bytes, or why there are none. Lengths are in metres,
// y up.
#pragma once

#include "base/result.h"
#include "export/surface.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ripstop {

// With texture points and normals. Vertices are particles, faces panels, lines links that are no
// thread of the fabric.
std::string objText(const Surface& surface);

// The materials beside an OBJ, where fabrics have pictures: a file, what is in it, and the line by
// which the OBJ names it. Nothing for plain fabrics and for other formats.
struct ObjMaterials
{
    std::filesystem::path file;
    std::string text;
    std::string line;
};
std::optional<ObjMaterials> objMaterials(const std::filesystem::path& obj,
                                         const MeshAppearance& appearance);

// Particles with velocities, panels, and all links with strain and tension; text, numbers exact.
Result<std::string> plyMoment(const Frame& frame, const MeshAppearance& appearance);

// VTK PolyData: all links as lines and panels as triangles with strain, tension and load, and
// velocity at the particles; binary, exact.
Result<std::string> vtpMoment(const Frame& frame, const MeshAppearance& appearance);

Result<std::string> objMoment(const Frame& frame, const MeshAppearance& appearance);

// The panels alone, binary, in single precision: the format knows neither lines nor shared corners.
Result<std::string> stlMoment(const Frame& frame, const MeshAppearance& appearance);

// Collada, with lines, normals, texture points and the colours of the fabrics; by assimp.
Result<std::string> colladaMoment(const Frame& frame, const MeshAppearance& appearance);

// glTF 2.0 in one file, with the same.
Result<std::string> glbMoment(const Frame& frame, const MeshAppearance& appearance);

} // namespace ripstop
