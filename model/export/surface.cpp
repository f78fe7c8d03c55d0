#include "export/surface.h"

#include "export/standing.h"

#include <Eigen/Geometry>

namespace ripstop {

Surface surfaceOf(const Frame& frame, const MeshAppearance& appearance)
{
    const Layout& layout = *frame.layout;
    const Standing whole = standing(frame);

    Surface surface;
    surface.name = appearance.name();
    surface.fabrics = appearance.fabrics();
    surface.position = frame.position;
    if (appearance.isTextured())
        for (const std::uint32_t id : layout.particleId)
            surface.texture.push_back(appearance.textureOf(id));
    takePrints(surface, appearance, layout.particleId);
    for (const std::size_t i : whole.panels) {
        surface.panels.push_back(layout.panelCorners[i]);
        surface.fabric.push_back(appearance.fabricOf(layout.panelId[i]));
    }
    for (const std::size_t i : whole.links) {
        const Layout::Link& link = layout.links[i];
        if (!appearance.isLine(link.id))
            continue;
        surface.lines.push_back({link.a, link.b});
        surface.lineFabric.push_back(appearance.fabricOf(link.id));
    }
    return surface;
}

void takePrints(Surface& surface, const MeshAppearance& appearance,
                std::span<const std::uint32_t> particle)
{
    surface.prints.resize(surface.fabrics.size());
    for (std::size_t fabric = 0; fabric < surface.fabrics.size(); ++fabric)
        if (!surface.fabrics[fabric].picture.empty())
            for (const std::uint32_t id : particle)
                surface.prints[fabric].push_back(appearance.printOf(fabric, id));
}

std::vector<Vec3> normalsOf(const Surface& surface)
{
    std::vector<Vec3> normals(surface.position.size(), Vec3::Zero());
    for (const auto& [a, b, c] : surface.panels) {
        const Vec3& corner = surface.position[std::size_t(a)];
        const Vec3 twiceArea = (surface.position[std::size_t(b)] - corner)
                                   .cross(surface.position[std::size_t(c)] - corner);
        for (const int i : {a, b, c})
            normals[std::size_t(i)] += twiceArea;
    }
    for (Vec3& normal : normals)
        if (const double length = normal.norm(); length > 0.0)
            normal /= length;
    return normals;
}

} // namespace ripstop
