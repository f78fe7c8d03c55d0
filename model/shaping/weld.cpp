// Welds in three stages: particles are joined into clusters, all of them or those within the
// distance, found in cells of that size; each cluster becomes its first particle, with the mass of
// all and the pin or guide of any; then RowRenamer gives links and panels their new ends, removes
// those that lost one or became like another, and passes references on (scene/references.h). Rows
// that stay as they are come first, so that a changed one gives way to them.
#include "shaping/weld.h"

#include "base/joined_sets.h"
#include "base/key_index.h"
#include "scene/references.h"
#include "shaping/movable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace ripstop {
namespace {

// Joins particles within the distance. Cells have the size of the distance, so that only particles
// in 27 of them can be near enough.
void joinNear(JoinedSets& clusters, const std::vector<const Particle*>& rows, double distance)
{
    using Cell = std::array<std::int64_t, 3>;
    std::map<Cell, std::vector<int>> cells;
    const auto cellOf = [&](const Vec3& place) {
        Cell cell;
        for (int axis = 0; axis < 3; ++axis)
            cell[std::size_t(axis)] = std::int64_t(std::floor(place[axis] / distance));
        return cell;
    };
    for (int i = 0; i < int(rows.size()); ++i) {
        const Vec3& place = rows[std::size_t(i)]->position;
        const Cell home = cellOf(place);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    const auto cell = cells.find({home[0] + dx, home[1] + dy, home[2] + dz});
                    if (cell == cells.end())
                        continue;
                    for (const int other : cell->second)
                        if ((rows[std::size_t(other)]->position - place).norm() <= distance)
                            clusters.join(i, other);
                }
        cells[home].push_back(i);
    }
}

// Which particle each one becomes.
class Renamed
{
public:
    explicit Renamed(std::size_t count)
        : m_place(count)
    {}

    void add(Id gone, Id kept)
    {
        m_place.add(std::uint32_t(gone), int(m_kept.size()));
        m_kept.push_back(kept);
    }
    Id operator()(Id id) const
    {
        const int place = m_place(std::uint32_t(id));
        return place == KeyIndex::none ? id : m_kept[std::size_t(place)];
    }
    bool isGone(Id id) const { return m_place(std::uint32_t(id)) != KeyIndex::none; }

private:
    KeyIndex m_place;
    std::vector<Id> m_kept;
};

class Columns
{
public:
    explicit Columns(const Property& property)
        : m_change{&property, {}, {}}
    {}
    void set(Id id, Value value)
    {
        m_change.targets.push_back(id);
        m_change.values.push_back(std::move(value));
    }
    void addTo(Edit& edit)
    {
        if (!m_change.targets.empty())
            edit.changes.emplace_back(std::move(m_change));
    }

private:
    SetValues m_change;
};

// Gives links and panels new ends and corners, and removes those that have lost one or have become
// what another one is already.
class RowRenamer
{
public:
    RowRenamer(const Scene& scene, const Renamed& renamed)
        : m_scene(scene)
        , m_renamed(renamed)
    {
        // those that stay as they are come first, so that a changed one gives way to them
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& row : part.links)
                if (!changes({row.from, row.to}))
                    m_links.insert(keyOf(row));
            for (const Panel& row : part.panels)
                if (!changes({row.a, row.b, row.c}))
                    m_panels.insert(keyOf(row));
        });
    }

    void addTo(Weld& weld)
    {
        std::vector<RemoveRows> removals;
        std::vector<Id> removed; // links and panels
        forEachPart(m_scene, [&](Id id, const Part& part) {
            RemoveRows rows{id, {}, {}, {}};
            for (const Particle& row : part.particles)
                if (m_renamed.isGone(row.id))
                    rows.particles.push_back(row.id);
            for (const Link& row : part.links)
                if (changes({row.from, row.to}) && !rename(row))
                    rows.links.push_back(row.id);
            for (const Panel& row : part.panels)
                if (changes({row.a, row.b, row.c}) && !rename(row))
                    rows.panels.push_back(row.id);
            weld.links += rows.links.size();
            weld.panels += rows.panels.size();
            removed.insert(removed.end(), rows.links.begin(), rows.links.end());
            removed.insert(removed.end(), rows.panels.begin(), rows.panels.end());
            if (!rows.particles.empty() || !rows.links.empty() || !rows.panels.empty())
                removals.push_back(std::move(rows));
        });
        m_from.addTo(weld.edit);
        m_to.addTo(weld.edit);
        for (Columns& column : m_corners)
            column.addTo(weld.edit);
        std::sort(removed.begin(), removed.end());
        passOn(weld.edit, m_scene, [&](Id id, std::vector<Id>& heirs) {
            if (!std::binary_search(removed.begin(), removed.end(), id))
                heirs.push_back(m_renamed(id));
        });
        for (RemoveRows& rows : removals)
            weld.edit.changes.emplace_back(std::move(rows));
    }

private:
    using LinkKey = std::tuple<Id, Id, LinkKind, Id>;
    using PanelKey = std::array<Id, 3>;

    bool changes(std::initializer_list<Id> ends) const
    {
        return std::ranges::any_of(ends, [&](Id id) { return m_renamed.isGone(id); });
    }

    LinkKey keyOf(const Link& row) const
    {
        const Id a = m_renamed(row.from), b = m_renamed(row.to);
        return {std::min(a, b), std::max(a, b), row.kind, row.material};
    }

    PanelKey keyOf(const Panel& row) const
    {
        PanelKey key{m_renamed(row.a), m_renamed(row.b), m_renamed(row.c)};
        std::sort(key.begin(), key.end());
        return key;
    }

    // Notes the new ends of a row; false when the row has to go.
    bool rename(const Link& row)
    {
        const LinkKey key = keyOf(row);
        if (std::get<0>(key) == std::get<1>(key) || !m_links.insert(key).second)
            return false;
        if (m_renamed.isGone(row.from))
            m_from.set(row.id, m_renamed(row.from));
        if (m_renamed.isGone(row.to))
            m_to.set(row.id, m_renamed(row.to));
        return true;
    }

    bool rename(const Panel& row)
    {
        const PanelKey key = keyOf(row);
        if (key[0] == key[1] || key[1] == key[2] || !m_panels.insert(key).second)
            return false;
        const std::array<Id, 3> ends{row.a, row.b, row.c};
        for (std::size_t k = 0; k < 3; ++k)
            if (m_renamed.isGone(ends[k]))
                m_corners[k].set(row.id, m_renamed(ends[k]));
        return true;
    }

    const Scene& m_scene;
    const Renamed& m_renamed;
    std::set<LinkKey> m_links;
    std::set<PanelKey> m_panels;
    Columns m_from{propertyOf<&Link::from>()};
    Columns m_to{propertyOf<&Link::to>()};
    std::array<Columns, 3> m_corners{Columns(propertyOf<&Panel::a>()),
                                     Columns(propertyOf<&Panel::b>()),
                                     Columns(propertyOf<&Panel::c>())};
};

Weld weldClusters(const Scene& scene, const std::vector<const Particle*>& rows,
                  JoinedSets& clusters, WeldAt at)
{
    Weld weld{{Message("Weld"), {}}, {}};
    struct Sum
    {
        Vec3 place = Vec3::Zero();
        double mass = 0.0;
        int count = 0;
        bool pinned = false;
        const Particle* guided = nullptr; // the first that has a guide
    };
    std::vector<Sum> sums(rows.size());
    Renamed renamed(rows.size());
    for (int i = 0; i < int(rows.size()); ++i) {
        const Particle& row = *rows[std::size_t(i)];
        const int first = clusters.of(i);
        Sum& sum = sums[std::size_t(first)];
        sum.place += row.position;
        sum.mass += row.mass;
        sum.pinned |= row.pinned;
        if (row.guide != Guide::None && !sum.guided)
            sum.guided = &row;
        ++sum.count;
        if (first != i) {
            renamed.add(row.id, rows[std::size_t(first)]->id);
            ++weld.merged;
        }
    }
    if (weld.merged == 0)
        return weld;
    Columns position(propertyOf<&Particle::position>()), mass(propertyOf<&Particle::mass>()),
        pinned(propertyOf<&Particle::pinned>()), guide(propertyOf<&Particle::guide>()),
        guideAxis(propertyOf<&Particle::guideAxis>());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Sum& sum = sums[i];
        if (sum.count < 2)
            continue;
        const Id id = rows[i]->id;
        weld.kept.push_back(id);
        mass.set(id, sum.mass);
        pinned.set(id, sum.pinned);
        if (sum.guided && sum.guided->id != id) {
            guide.set(id, propertyOf<&Particle::guide>().get(sum.guided));
            guideAxis.set(id, sum.guided->guideAxis);
        }
        if (at == WeldAt::Middle)
            position.set(id, Vec3(sum.place / sum.count));
    }
    position.addTo(weld.edit);
    mass.addTo(weld.edit);
    pinned.addTo(weld.edit);
    guide.addTo(weld.edit);
    guideAxis.addTo(weld.edit);
    RowRenamer(scene, renamed).addTo(weld);
    return weld;
}

std::vector<const Particle*> rowsOf(const Scene& scene, const std::vector<Id>& ids)
{
    std::vector<const Particle*> rows;
    for (const Id id : particlesOf(scene, ids))
        rows.push_back(std::get<const Particle*>(*find(scene, id)));
    return rows;
}

} // namespace

Weld welded(const Scene& scene, const std::vector<Id>& ids, WeldAt at)
{
    const auto rows = rowsOf(scene, ids);
    JoinedSets clusters(rows.size());
    for (int i = 1; i < int(rows.size()); ++i)
        clusters.join(0, i);
    return weldClusters(scene, rows, clusters, at);
}

Weld weldedWithin(const Scene& scene, const std::vector<Id>& ids, double distance, WeldAt at)
{
    const auto rows = rowsOf(scene, ids);
    JoinedSets clusters(rows.size());
    joinNear(clusters, rows, std::max(distance, 1e-12));
    return weldClusters(scene, rows, clusters, at);
}

} // namespace ripstop
