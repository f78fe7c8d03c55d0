// of() refuses a series whose panels change their ids, then lays vertices for the particles of the
// last layout that addParticles() finds to stay, and after them for the corners of its panels and
// the ends of its lines that do not. vertexAt() shares a vertex among all that stay whole and gives
// a new one to each corner that may go. The first frame gives
// the surface its positions.
//
// positions() fills the vertices for one frame. followLinks() finds the links of the last layout in
// that of the frame, by id where the two have different counts, since tears add links; panels keep
// their indices. Then each vertex takes the place of its particle in that layout, or the middle of
// its panel or link when this is gone.
#include "export/constant_mesh.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace ripstop {
namespace {

// The earliest frame whose panels are others than those of the last.
std::optional<std::size_t> otherDesign(const FrameSpool& spool)
{
    const Layout& last = spool.layout(spool.count() - 1);
    const Layout* checked = &last;
    for (std::size_t i = 0; i < spool.count(); ++i) {
        const Layout& layout = spool.layout(i);
        if (&layout != checked && layout.panelId != last.panelId)
            return i;
        checked = &layout;
    }
    return std::nullopt;
}

Eigen::Vector3f middle(const FrameSpool::Shape& shape, std::span<const int> corners)
{
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const int corner : corners)
        sum += shape.position[std::size_t(corner)];
    return sum / float(corners.size());
}

} // namespace

Result<ConstantMesh> ConstantMesh::of(FrameSpool& spool, const MeshAppearance& appearance)
{
    if (const auto other = otherDesign(spool))
        return Failure("The panels of the design change after %1 s, and this format knows one mesh "
                       "only; choose a sequence of files.",
                       Message::number("%f", spool.time(*other)));

    ConstantMesh mesh;
    const Layout& last = spool.layout(spool.count() - 1);
    mesh.m_last = &last;
    mesh.m_vertexOf.assign(last.particleId.size(), -1);
    mesh.m_surface.name = appearance.name();
    mesh.m_surface.fabrics = appearance.fabrics();
    mesh.addParticles(spool, appearance);
    for (std::size_t i = 0; i < last.panelCorners.size(); ++i) {
        std::array<int, 3> corners{};
        for (const std::size_t k : {0u, 1u, 2u})
            corners[k] = mesh.vertexAt(std::size_t(last.panelCorners[i][k]),
                                       {Source::Of::Panel, i, k, spool.everGone()[i] != 0});
        mesh.m_surface.panels.push_back(corners);
        mesh.m_surface.fabric.push_back(appearance.fabricOf(last.panelId[i]));
    }
    for (std::size_t i = 0; i < last.links.size(); ++i) {
        const Layout::Link& link = last.links[i];
        if (!appearance.isLine(link.id))
            continue;
        const bool mayGo = spool.everTorn()[i] != 0;
        mesh.m_surface.lines.push_back(
            {mesh.vertexAt(std::size_t(link.a), {Source::Of::Link, i, 0, mayGo}),
             mesh.vertexAt(std::size_t(link.b), {Source::Of::Link, i, 1, mayGo})});
        mesh.m_surface.lineFabric.push_back(appearance.fabricOf(link.id));
    }
    if (mesh.m_surface.panels.empty() && mesh.m_surface.lines.empty())
        return Failure{"The scene has neither fabric nor lines, so there is nothing to show."};

    const auto first = mesh.positions(spool, 0);
    if (!first)
        return first.failure();
    for (const Eigen::Vector3f& x : *first)
        mesh.m_surface.position.push_back(x.cast<double>());
    std::vector<std::uint32_t> ids; // of the vertices
    for (const Source& source : mesh.m_vertices)
        ids.push_back(last.particleId[mesh.particleOf(last, source)]);
    if (appearance.isTextured())
        for (const std::uint32_t id : ids)
            mesh.m_surface.texture.push_back(appearance.textureOf(id));
    takePrints(mesh.m_surface, appearance, ids);
    return mesh;
}

// A vertex for each particle, in their order, but for those of which all that they hold may go.
void ConstantMesh::addParticles(const FrameSpool& spool, const MeshAppearance& appearance)
{
    const std::size_t count = m_last->particleId.size();
    std::vector<std::optional<Source>> staying(count);
    std::vector<char> isHeld(count, 0);
    const auto take = [&](int particle, const Source& source) {
        isHeld[std::size_t(particle)] = 1;
        if (!source.mayGo)
            staying[std::size_t(particle)] = source;
    };
    for (std::size_t i = 0; i < m_last->panelCorners.size(); ++i)
        for (const std::size_t k : {0u, 1u, 2u})
            take(m_last->panelCorners[i][k], {Source::Of::Panel, i, k, spool.everGone()[i] != 0});
    for (std::size_t i = 0; i < m_last->links.size(); ++i)
        if (const Layout::Link& link = m_last->links[i]; appearance.isLine(link.id))
            for (const std::size_t k : {0u, 1u})
                take(k == 0 ? link.a : link.b, {Source::Of::Link, i, k, spool.everTorn()[i] != 0});
    for (std::size_t i = 0; i < count; ++i)
        if (!isHeld[i])
            (void)vertexAt(i, {Source::Of::Particle, i, 0, false});
        else if (staying[i])
            (void)vertexAt(i, *staying[i]);
}

// Particles of what stays are shared, as in the design.
int ConstantMesh::vertexAt(std::size_t particle, const Source& source)
{
    int& vertex = m_vertexOf[particle];
    if (source.mayGo || vertex < 0) {
        m_vertices.push_back(source);
        const int added = int(m_vertices.size()) - 1;
        if (source.mayGo)
            return added;
        vertex = added;
    }
    return vertex;
}

std::size_t ConstantMesh::particleOf(const Layout& layout, const Source& source) const
{
    if (source.of == Source::Of::Panel)
        return std::size_t(layout.panelCorners[source.element][source.corner]);
    if (source.of == Source::Of::Particle) { // which tears, that add particles, do not split
        const auto& ids = layout.particleId;
        const std::uint32_t id = m_last->particleId[source.element];
        const bool isThere = source.element < ids.size() && ids[source.element] == id;
        return isThere ? source.element : std::size_t(std::ranges::find(ids, id) - ids.begin());
    }
    const Layout::Link& link =
        layout.links[&layout == m_last ? source.element : m_linkAt[source.element]];
    return std::size_t(source.corner == 0 ? link.a : link.b);
}

// Finds the links of the last layout in another. Links that a tear has doubled have one id, and are
// no lines.
std::optional<Failure> ConstantMesh::followLinks(const Layout& layout, double time)
{
    if (&layout == m_followed)
        return std::nullopt;
    m_followed = &layout;
    m_linkAt.resize(m_last->links.size());
    if (layout.links.size() == m_last->links.size()) {
        std::iota(m_linkAt.begin(), m_linkAt.end(), std::size_t(0));
        return std::nullopt;
    }
    std::vector<std::pair<std::uint32_t, std::size_t>> byId;
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        byId.emplace_back(layout.links[i].id, i);
    std::ranges::sort(byId);
    for (const Source& source : m_vertices) {
        if (source.of != Source::Of::Link)
            continue;
        const std::pair<std::uint32_t, std::size_t> wanted{m_last->links[source.element].id, 0};
        const auto found = std::ranges::lower_bound(byId, wanted);
        if (found == byId.end() || found->first != wanted.first)
            return Failure(
                "The lines of the design change after %1 s, and this format knows one mesh "
                "only; choose a sequence of files.",
                Message::number("%f", time));
        m_linkAt[source.element] = found->second;
    }
    return std::nullopt;
}

Result<std::vector<Eigen::Vector3f>> ConstantMesh::positions(FrameSpool& spool, std::size_t frame)
{
    const Layout& layout = spool.layout(frame);
    if (auto failure = followLinks(layout, spool.time(frame)))
        return *failure;
    const auto shape = spool.read(frame);
    if (!shape)
        return shape.failure();

    std::vector<Eigen::Vector3f> places;
    places.reserve(m_vertices.size());
    for (const Source& source : m_vertices) {
        if (source.of == Source::Of::Panel && shape->gone[source.element]) {
            places.push_back(middle(*shape, layout.panelCorners[source.element]));
        } else if (source.of == Source::Of::Link && shape->torn[m_linkAt[source.element]]) {
            const Layout::Link& link = layout.links[m_linkAt[source.element]];
            places.push_back(middle(*shape, std::array{link.a, link.b}));
        } else {
            places.push_back(shape->position[particleOf(layout, source)]);
        }
    }
    return places;
}

} // namespace ripstop
