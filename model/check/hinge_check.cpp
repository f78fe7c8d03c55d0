// A corner where something else is tied may be held by it, as frames are by rigging and cloth; so
// only one where two links of one spar meet and nothing else is told.
#include "check/hinge_check.h"

#include "derived/material_of.h"
#include "derived/panel_sides.h"
#include "laws/joined_spars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace ripstop {
namespace {

struct Corner // a particle
{
    const Particle* particle = nullptr;
    std::array<const Link*, 2> links{};
    int ties = 0; // links, and panels
};

class Corners
{
public:
    Corners(const Scene& scene, const ElementIndex& index)
        : m_scene(scene)
        , m_index(index)
    {
        std::size_t particles = 0;
        forEachPart(scene, [&](Id, const Part& part) { particles += part.particles.size(); });
        m_corners.resize(particles);
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Particle& particle : part.particles)
                if (Corner* corner = at(particle.id))
                    corner->particle = &particle;
        });
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& link : part.links) {
                m_sides.push_back(sideOf(link.from, link.to));
                for (const Id end : {link.from, link.to})
                    if (Corner* corner = at(end); corner && corner->ties++ < 2)
                        corner->links[std::size_t(corner->ties - 1)] = &link;
            }
            for (const Panel& panel : part.panels)
                for (const Id id : {panel.a, panel.b, panel.c})
                    if (Corner* corner = at(id))
                        corner->ties += 3;
        });
        std::ranges::sort(m_sides);
    }

    void report(const AddFinding& add) const
    {
        for (const Corner& corner : m_corners)
            if (isOfOneSpar(corner))
                if (const std::optional<double> turn = turnOf(corner))
                    add("hinge", Severity::Warning,
                        Message("At particle #%1 a spar of %2 turns by %3 degrees, and nothing "
                                "else is tied there: it moves as on a hinge, since spars go on "
                                "into each other up to 60 degrees. Bend it in smaller angles, or "
                                "brace it.",
                                std::uint32_t(corner.particle->id),
                                materialOf(m_scene, m_index, corner.links[0]->material).name,
                                Message::number("%.0f", *turn)),
                        corner.particle->id);
    }

private:
    Corner* at(Id id)
    {
        const int place = m_index.particle(id);
        return place >= 0 ? &m_corners[std::size_t(place)] : nullptr;
    }

    bool isOfOneSpar(const Corner& corner) const
    {
        const auto& [one, other] = corner.links;
        return corner.ties == 2 && corner.particle && !corner.particle->pinned
               && one->material == other->material && !isBraced(corner)
               && materialOf(m_scene, m_index, one->material).flexuralRigidity > 0.0;
    }

    bool isBraced(const Corner& corner) const // by a link from end to end
    {
        const auto endOf = [&](const Link& link) {
            return link.from == corner.particle->id ? link.to : link.from;
        };
        return std::ranges::binary_search(m_sides,
                                          sideOf(endOf(*corner.links[0]), endOf(*corner.links[1])));
    }

    Vec3 away(const Link& link, const Particle& from) const // unit, or zero
    {
        const int place = m_index.particle(link.from == from.id ? link.to : link.from);
        const Particle* end = place >= 0 ? m_corners[std::size_t(place)].particle : nullptr;
        return end ? Vec3(end->position - from.position).normalized() : Vec3(Vec3::Zero());
    }

    // Degrees, where it is too much to go on; nothing of links without a direction.
    std::optional<double> turnOf(const Corner& corner) const
    {
        const Vec3 one = away(*corner.links[0], *corner.particle);
        const Vec3 other = away(*corner.links[1], *corner.particle);
        const double along = -one.dot(other);
        if (one.isZero() || other.isZero() || along >= leastAlongOfSpars)
            return std::nullopt;
        return std::acos(std::max(along, -1.0)) * 180.0 / std::numbers::pi;
    }

    const Scene& m_scene;
    const ElementIndex& m_index;
    std::vector<Corner> m_corners;  // [particles]
    std::vector<PanelSide> m_sides; // of links, in order
};

} // namespace

void checkHinges(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    const bool hasSpars = std::ranges::any_of(scene.items, [](const Entry& entry) {
        const auto* material = std::get_if<Material>(&entry.item);
        return material && material->flexuralRigidity > 0.0;
    });
    if (hasSpars)
        Corners(scene, index).report(add);
}

} // namespace ripstop
