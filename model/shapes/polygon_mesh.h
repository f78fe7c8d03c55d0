// A mesh as its file has it: polygons with any number of corners, the names of objects and
// materials, and what the file says of units.
// Readers fill it (mesh_file.h), and the import repairs it (author/mesh_repair.h) and makes a
// network of it. Points are in the unit of the file, as arrays by face and by corner; nothing is
// joined or split yet.
#pragma once

#include "base/vec3.h"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ripstop {

struct PolygonMesh
{
    using TexturePoint = std::array<double, 2>; // u, v

    // The texture point of a corner that has none, in a file where others have one.
    static TexturePoint noTexture()
    {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none};
    }

    struct Material
    {
        std::string name;
        std::string color;   // "#rrggbb", or empty when the file does not say
        std::string picture; // a file, as seen from the mesh's folder until mesh_file.h finds it;
                             // or "*" and the index of a packed one until then
    };

    // One that lies within the mesh's file (packed_pictures.h).
    struct PackedPicture
    {
        std::string name;  // as the file has it, or empty
        std::string bytes; // of a PNG or JPEG, or of what nobody knows
        std::string file;  // where it is to be written, absolute; empty where it cannot be drawn
    };

    std::vector<Vec3> points;               // [points] in the unit of the file
    std::vector<int> first{0};              // [faces + 1] where the corners of each face begin
    std::vector<int> corners;               // [corners] indices of points
    std::vector<TexturePoint> texture;      // [corners], or empty
    std::vector<int> object;                // [faces] index into `objects`
    std::vector<int> material;              // [faces] index into `materials`
    std::vector<std::string> objects;       // names
    std::vector<Material> materials;        // names and colours
    std::vector<std::string> materialFiles; // that the file names, as its lines have them
    std::vector<PackedPicture> pictures;    // that lie within the file
    std::vector<std::string> missingFiles;  // of colours and pictures, which the file names in vain
    std::vector<std::array<int, 2>> lines;  // [lines] the points that each ties, beside the faces
    std::vector<double> mass;               // [points] kg, or empty when the file does not say
    std::optional<double> unit;             // m, when the format or the file says
    bool isUpright = false;                 // y is up, because the format or the file says so
    std::size_t strayElements = 0;          // other lines and single points, which are left out

    std::size_t faceCount() const { return first.size() - 1; }
    std::span<const int> face(std::size_t i) const
    {
        return {corners.data() + first[i], std::size_t(first[i + 1] - first[i])};
    }

    // Ends the face whose corners have been added last.
    void endFace(int ofObject, int ofMaterial)
    {
        first.push_back(int(corners.size()));
        object.push_back(ofObject);
        material.push_back(ofMaterial);
    }
};

} // namespace ripstop
