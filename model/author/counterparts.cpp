// Pairs what a builder made with what stands in a scene:
// 1. motionOf() finds where the part went: a shift that most particles of a sample agree on, so
//    that those moved by hand do not count, or else the best rigid motion of all (Umeyama 1991).
// 2. Rows are paired in their order where the tables are as long; materials follow from paired
//    rows.
// 3. Other items are paired by name and by pointing at the part; each item of the scene is taken
//    once.
#include "author/counterparts.h"

#include "scene/property.h"

#include <algorithm>
#include <set>

namespace ripstop {
namespace {

std::size_t countAt(const std::vector<Particle>& built, const std::vector<Particle>& held,
                    const Eigen::Affine3d& map, double tolerance)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(built.size(), held.size()); ++i)
        count += (map * built[i].position - held[i].position).norm() <= tolerance;
    return count;
}

// The shift that takes most of a sample of particles to where they are, so that those moved by hand
// do not count; else the rigid motion that fits all best (Umeyama 1991).
Eigen::Affine3d motionOf(const std::vector<Particle>& built, const std::vector<Particle>& held,
                         double tolerance)
{
    Eigen::Affine3d best = Eigen::Affine3d::Identity();
    const std::size_t count = std::min(built.size(), held.size());
    const std::size_t step = std::max<std::size_t>(count / 7, 1);
    for (std::size_t i = 0; i < count; i += step) {
        const Eigen::Affine3d shift(Eigen::Translation3d(held[i].position - built[i].position));
        if (2 * countAt(built, held, shift, tolerance) > count)
            return shift;
    }
    if (built.size() != held.size() || count < 3)
        return best;
    Eigen::Matrix3Xd from(3, count);
    Eigen::Matrix3Xd to(3, count);
    for (std::size_t i = 0; i < count; ++i) {
        from.col(Eigen::Index(i)) = built[i].position;
        to.col(Eigen::Index(i)) = held[i].position;
    }
    best.matrix() = Eigen::umeyama(from, to, false);
    return best;
}

// "sail" and "sail 2" for "sail", and not "sailor" or "sail two".
bool isNamedAfter(const std::string& name, const std::string& base)
{
    if (!name.starts_with(base))
        return false;
    const std::string rest = name.substr(base.size());
    return rest.empty()
           || (rest.size() > 1 && rest[0] == ' '
               && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

class Pairing
{
public:
    Pairing(const Scene& scene, Id part, const Scene& built)
        : m_scene(scene)
        , m_built(built)
        , m_heldId(part)
        , m_made(std::get<Part>(partEntry(built).item))
        , m_held(*findItem<Part>(scene, part))
    {}

    Counterparts run()
    {
        Eigen::AlignedBox3d box;
        for (const Particle& row : m_made.particles)
            box.extend(row.position);
        m_pairs.tolerance = box.isEmpty() ? 0.0 : 1e-9 + 1e-7 * box.sizes().norm();
        m_pairs.motion.map = motionOf(m_made.particles, m_held.particles, m_pairs.tolerance);
        m_pairs.heldAs[partEntry(m_built).id] = m_heldId;
        pairRows(m_made.particles, m_held.particles);
        pairRows(m_made.links, m_held.links);
        pairRows(m_made.panels, m_held.panels);
        pairMaterials(m_made.links, m_held.links);
        pairMaterials(m_made.panels, m_held.panels);
        noteElements();
        for (const Entry& entry : m_built.items)
            if (!m_pairs.heldAs.contains(entry.id))
                pairByName(entry);
        return std::move(m_pairs);
    }

private:
    template <typename Row>
    void pairRows(const std::vector<Row>& made, const std::vector<Row>& held)
    {
        if (made.size() != held.size())
            return;
        for (std::size_t i = 0; i < made.size(); ++i)
            m_pairs.heldAs[made[i].id] = held[i].id;
    }

    // Pairs each material with that of the counterpart of the first row that is made of it.
    template <typename Row>
    void pairMaterials(const std::vector<Row>& made, const std::vector<Row>& held)
    {
        if (made.size() != held.size())
            return;
        for (std::size_t i = 0; i < made.size(); ++i)
            if (m_seen.insert(made[i].material).second && held[i].material != noId) {
                m_pairs.heldAs[made[i].material] = held[i].material;
                m_taken.insert(held[i].material);
            }
    }

    void noteElements()
    {
        m_elements.insert(m_heldId);
        for (const Particle& row : m_held.particles)
            m_elements.insert(row.id);
        for (const Link& row : m_held.links)
            m_elements.insert(row.id);
        for (const Panel& row : m_held.panels)
            m_elements.insert(row.id);
    }

    // Whether the item points at something of the part, or at nothing.
    bool isOfPart(const Item& item) const
    {
        bool points = false;
        bool ours = false;
        std::visit(
            [&](const auto& one) {
                for (const Property& property : propertiesOf(kindOf(ConstRef(&one)))) {
                    if (property.pointsAt.empty())
                        continue;
                    const Value value = property.get(&one);
                    const auto look = [&](Id id) {
                        points = points || id != noId;
                        ours = ours || m_elements.contains(id);
                    };
                    if (const Id* id = std::get_if<Id>(&value))
                        look(*id);
                    if (const auto* list = std::get_if<std::vector<Id>>(&value))
                        std::ranges::for_each(*list, look);
                }
            },
            item);
        return ours || !points;
    }

    void pairByName(const Entry& made)
    {
        const Entry* best = nullptr;
        for (const Entry& entry : m_scene.items) {
            if (entry.item.index() != made.item.index() || m_taken.contains(entry.id)
                || !isNamedAfter(nameOf(entry.item), nameOf(made.item)) || !isOfPart(entry.item))
                continue;
            if (!best || nameOf(entry.item) == nameOf(made.item))
                best = &entry;
        }
        if (!best)
            return;
        m_pairs.heldAs[made.id] = best->id;
        m_taken.insert(best->id);
    }

    const Scene& m_scene;
    const Scene& m_built;
    Id m_heldId;
    const Part& m_made;
    const Part& m_held;
    std::set<Id> m_elements; // of the part, and the part itself
    std::set<Id> m_seen;     // materials of the built scene
    std::set<Id> m_taken;    // items of the scene that have a counterpart
    Counterparts m_pairs;
};

} // namespace

const Entry& partEntry(const Scene& built)
{
    return *std::ranges::find_if(
        built.items, [](const Entry& entry) { return std::holds_alternative<Part>(entry.item); });
}

Counterparts counterpartsOf(const Scene& scene, Id part, const Scene& built)
{
    return Pairing(scene, part, built).run();
}

} // namespace ripstop
