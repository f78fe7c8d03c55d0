// Fabric and lines as other programs know them: vertices, triangles, edges. Lengths are in metres,
// y up.
#pragma once

#include "export/appearance.h"
#include "simulation/frame.h"

#include <array>
#include <span>
#include <vector>

namespace ripstop {

struct Surface
{
    std::string name;
    std::vector<Vec3> position;                        // [vertices] m, y up
    std::vector<MeshAppearance::TexturePoint> texture; // [vertices], or empty
    // [fabrics][vertices] in the picture of the fabric; empty for one without
    std::vector<std::vector<MeshAppearance::TexturePoint>> prints;
    std::vector<std::array<int, 3>> panels; // corners, counter-clockwise seen from the front
    std::vector<std::size_t> fabric;        // [panels] index into `fabrics`
    std::vector<std::array<int, 2>> lines;  // links but for the threads of fabric
    std::vector<std::size_t> lineFabric;    // [lines] index into `fabrics`
    std::vector<MeshAppearance::Fabric> fabrics;

    bool isPrinted(std::size_t one) const { return one < prints.size() && !prints[one].empty(); }
};

// Every particle is a vertex, so that vertex i is the same particle in every moment. Panels that
// are gone and links that are torn are left out.
Surface surfaceOf(const Frame& frame, const MeshAppearance& appearance);

// The vertices' places in the pictures of all fabrics, where `particle` has the id of each vertex.
void takePrints(Surface& surface, const MeshAppearance& appearance,
                std::span<const std::uint32_t> particle);

// What is made of one of the fabrics, of panels with `fabric` or of lines with `lineFabric`.
template <std::size_t count>
std::vector<std::array<int, count>> madeOf(std::size_t fabric,
                                           const std::vector<std::size_t>& fabrics,
                                           const std::vector<std::array<int, count>>& elements)
{
    std::vector<std::array<int, count>> made;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (fabrics[i] == fabric)
            made.push_back(elements[i]);
    return made;
}

// Of unit length, the mean of the panels around by their areas; zero where there is none.
std::vector<Vec3> normalsOf(const Surface& surface);

} // namespace ripstop
