#include "scene/element_index.h"

namespace ripstop {
namespace {

constexpr int itemTag = 3;

int tagOf(Kind kind)
{
    static_assert(int(Kind::Link) == int(Kind::Particle) + 1);
    static_assert(int(Kind::Panel) == int(Kind::Particle) + 2);
    return isElement(kind) ? int(kind) - int(Kind::Particle) : itemTag;
}

std::size_t rowCount(const Scene& scene)
{
    std::size_t count = scene.items.size();
    forEachPart(scene, [&](Id, const Part& part) {
        count += part.particles.size() + part.links.size() + part.panels.size();
    });
    return count;
}

} // namespace

ElementIndex::ElementIndex(const Scene& scene)
    : m_index(rowCount(scene))
{
    int particles = 0;
    int links = 0;
    int panels = 0;
    for (const Entry& entry : scene.items) {
        const Kind kind = std::visit(
            [](const auto& item) { return ripstop::kindOf(ConstRef(&item)); }, entry.item);
        m_kind.push_back(kind);
        add(entry.id, kind, int(m_kind.size()) - 1);
        if (const Part* part = std::get_if<Part>(&entry.item)) {
            for (const Particle& row : part->particles)
                add(row.id, Kind::Particle, particles++);
            for (const Link& row : part->links)
                add(row.id, Kind::Link, links++);
            for (const Panel& row : part->panels)
                add(row.id, Kind::Panel, panels++);
        }
    }
}

void ElementIndex::add(Id id, Kind kind, int place)
{
    if (!m_index.add(std::uint32_t(id), 4 * place + tagOf(kind)))
        m_repeated.push_back(id);
}

int ElementIndex::placeOf(Id id, Kind kind) const
{
    const int found = m_index(std::uint32_t(id));
    return found >= 0 && (found & 3) == tagOf(kind) ? found >> 2 : -1;
}

int ElementIndex::material(Id id) const
{
    const int found = m_index(std::uint32_t(id));
    const bool item = found >= 0 && (found & 3) == itemTag;
    return item && m_kind[std::size_t(found >> 2)] == Kind::Material ? found >> 2 : -1;
}

std::optional<Kind> ElementIndex::kindOf(Id id) const
{
    const int found = m_index(std::uint32_t(id));
    if (found < 0)
        return std::nullopt;
    if ((found & 3) == itemTag)
        return m_kind[std::size_t(found >> 2)];
    return Kind(int(Kind::Particle) + (found & 3));
}

} // namespace ripstop
