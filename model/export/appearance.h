// What a scene gives to a mesh besides its shape: where the picture on the fabric lies and what
// colour it has.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ripstop {

class MeshAppearance
{
public:
    struct Fabric
    {
        std::string name;
        std::array<double, 3> color;        // red, green, blue, 0 to 1, as screens have them (sRGB)
        std::filesystem::path picture = {}; // on the fabric, a PNG or JPEG; empty for none
        double thickness = 0.0;             // m, of round lines and spars of it; 0 where unknown
    };
    using TexturePoint = std::array<double, 2>; // u to the right and v up, 0 to 1

    MeshAppearance() = default;
    explicit MeshAppearance(const Scene& scene);

    // False when no particle has been given a place in the picture.
    bool isTextured() const { return !m_texture.empty(); }
    TexturePoint textureOf(std::uint32_t particle) const; // by id

    // The place in the picture of a fabric that has one, which may lie elsewhere than u and v do.
    TexturePoint printOf(std::size_t fabric, std::uint32_t particle) const;

    const std::string& name() const { return m_name; } // of the scene's first part
    const std::vector<Fabric>& fabrics() const { return m_fabrics; }
    std::size_t fabricOf(std::uint32_t element) const; // panel or link, by id; index into fabrics()

    // Whether a link is one by itself, a line or a spar, and none of the fabric: no thread, and no
    // spring that bends a woven one. By id.
    bool isLine(std::uint32_t link) const;
    bool isRound(std::uint32_t link) const; // such a link, of a thickness

private:
    template <typename T>
    using Rows = std::vector<std::pair<std::uint32_t, T>>; // by id, ascending

    std::string m_name = "fabric";
    Rows<TexturePoint> m_texture;
    Rows<std::size_t> m_fabricOf;
    std::vector<std::uint32_t> m_ofFabric;        // ids, ascending
    std::vector<Rows<TexturePoint>> m_prints{{}}; // [fabrics]
    std::vector<Fabric> m_fabrics{{"fabric", {0.8, 0.8, 0.8}}};
};

} // namespace ripstop
