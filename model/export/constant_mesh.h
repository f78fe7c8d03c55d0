// A mesh for formats that know only one for all frames, while fabric tears.
//
// The mesh is the last one of the series. Where it has split there, earlier frames have the corners
// of both sides in one place. Panels that are gone in the end have corners of their own, so that
// they can shrink to a point when they go; so have lines that break.
//
// Vertices are the particles in their order, as in the mesh of a single moment (surface.h), and
// then the corners and ends that may go. So of a flight without tears vertex i is particle i, and
// of an imported mesh of which nothing was joined or left out vertex i of its file. A particle of
// which all panels and lines go is no vertex.
#pragma once

#include "base/result.h"
#include "export/frame_spool.h"
#include "export/surface.h"

#include <optional>

namespace ripstop {

class ConstantMesh
{
public:
    // Of all that the spool holds, which must be one frame at least.
    static Result<ConstantMesh> of(FrameSpool& spool, const MeshAppearance& appearance);

    // The first frame; its panels and lines are those of all.
    const Surface& surface() const { return m_surface; }

    // The places of the vertices in a frame, m.
    Result<std::vector<Eigen::Vector3f>> positions(FrameSpool& spool, std::size_t frame);

private:
    // A corner of a panel or an end of a link, where a vertex lies in every frame, or a particle
    // that is neither.
    struct Source
    {
        enum class Of { Panel, Link, Particle } of;
        std::size_t element; // index in the last layout
        std::size_t corner;
        bool mayGo; // then the vertex is no one else's
    };

    void addParticles(const FrameSpool& spool, const MeshAppearance& appearance);
    int vertexAt(std::size_t particle, const Source& source);
    std::size_t particleOf(const Layout& layout, const Source& source) const;
    std::optional<Failure> followLinks(const Layout& layout, double time);

    Surface m_surface;
    const Layout* m_last = nullptr;
    std::vector<Source> m_vertices;
    std::vector<int> m_vertexOf;        // [particles of the last layout] or -1
    const Layout* m_followed = nullptr; // that the indices below are of
    std::vector<std::size_t> m_linkAt;  // [links of the last layout]
};

} // namespace ripstop
