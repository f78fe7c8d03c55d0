// The design is made in stages, each an edit of a draft: rows for what tears have doubled, places,
// velocities and pins of particles, places of carried colliders, removal of what is torn, and rest
// lengths where they are to be rebound. Twins get rows first, because all later stages name rows.
#include "run/pose.h"

#include "assembly/split_system.h"
#include "simulation/torn_system.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>

namespace ripstop {
namespace {

// A scene and all that is done to it.
struct Draft
{
    Posed posed;

    void make(Edit edit)
    {
        auto& changes = posed.edit.changes;
        (void)apply(posed.scene, edit);
        changes.insert(changes.end(), std::make_move_iterator(edit.changes.begin()),
                       std::make_move_iterator(edit.changes.end()));
    }
};

// Makes rows of what tears have doubled, and lets rows end where they end now.
class SplitWriter
{
public:
    SplitWriter(Draft& draft, const TornSystem& torn)
        : m_draft(draft)
        , m_scene(draft.posed.scene)
        , m_system(*torn.system)
        , m_origins(torn.splits)
    {}

    void write()
    {
        addParticles();
        for (const LinkPlace& link : m_system.links)
            if (link.key >= firstTwinLink)
                m_halved[m_origins.link(link.key)];
        forEachPart(m_scene, [&](Id id, const Part& part) {
            for (const Link& row : part.links)
                m_links[Key(row.id)] = {id, &row};
        });
        for (std::size_t i = 0; i < m_system.links.size(); ++i)
            writeLink(i);
        Edit edit{Message("Split"), {}};
        for (auto& [part, rows] : m_rows) {
            edit.changes.emplace_back(std::move(rows.first));
            edit.changes.emplace_back(std::move(rows.second));
        }
        for (std::size_t i = 0; i < m_system.panels.size(); ++i)
            writePanel(i, edit);
        m_draft.make(std::move(edit));
    }

    // Ids of the rows that there are now.
    Id particleId(int particle) const
    {
        const auto found = m_twins.find(particle);
        return found == m_twins.end() ? Id{m_system.key[std::size_t(particle)]} : found->second;
    }

    Id linkId(std::size_t link) const
    {
        const auto found = m_twinLinks.find(link);
        return found == m_twinLinks.end() ? Id{m_system.links[link].key} : found->second;
    }

private:
    struct LinkRow
    {
        Id part{};
        const Link* row = nullptr;
    };

    static void set(Edit& edit, const Property& property, Id target, Value value)
    {
        edit.changes.emplace_back(SetValues{&property, {target}, {std::move(value)}});
    }

    void addParticles()
    {
        std::map<Key, std::pair<Id, Particle>> rows;
        forEachPart(m_scene, [&](Id id, const Part& part) {
            for (const Particle& row : part.particles)
                rows[Key(row.id)] = {id, row};
        });
        Edit edit{Message("Split"), {}};
        for (std::size_t i = 0; i < m_system.key.size(); ++i) {
            if (m_system.key[i] < firstTwinParticle)
                continue;
            const Key origin = m_origins.particle(m_system.key[i]);
            auto [part, row] = rows[origin];
            row.id = takeId(m_scene);
            row.mass = m_system.mass[i];
            row.pinned = false;
            row.guide = Guide::None;
            m_twins[int(i)] = row.id;
            m_parted.insert_or_assign(origin, row.id);
            edit.changes.emplace_back(AddRows{part, {row}, {}, {}});
        }
        for (std::size_t i = 0; i < m_system.key.size(); ++i)
            if (m_parted.contains(m_system.key[i]))
                set(edit, propertyOf<&Particle::mass>(), Id{m_system.key[i]}, m_system.mass[i]);
        m_draft.make(std::move(edit));
    }

    void writeLink(std::size_t number)
    {
        const LinkPlace& link = m_system.links[number];
        const Key origin = m_origins.link(link.key);
        const LinkRow& from = m_links[origin];
        if (!from.row)
            return;
        Link row = *from.row;
        row.from = particleId(link.a);
        row.to = particleId(link.b);
        if (m_halved.contains(origin)) {
            const auto index = std::size_t(link.index);
            const bool held = link.kind == LinkKind::Rod;
            const TearLimit& tear = held ? m_system.rods[index].tear : m_system.springs[index].tear;
            if (row.kind == LinkKind::Spring) {
                const Spring spring =
                    held ? asSpring(m_system.rods[index]) : m_system.springs[index];
                row.stiffness = spring.stiffness;
                row.damping = spring.damping;
            } else {
                row.compliance = m_system.rods[index].compliance;
            }
            if (tear.rule == TearRule::Force)
                row.tearLimit = tear.limit;
        }
        if (row == *from.row && link.key == origin)
            return;
        auto& rows = m_rows
                         .try_emplace(from.part, RemoveRows{from.part, {}, {}, {}},
                                      AddRows{from.part, {}, {}, {}})
                         .first->second;
        if (link.key != origin)
            row.id = m_twinLinks[number] = takeId(m_scene);
        else
            rows.first.links.push_back(row.id);
        rows.second.links.push_back(row);
    }

    void writePanel(std::size_t panel, Edit& edit) const
    {
        const Property* const corners[]{&propertyOf<&Panel::a>(), &propertyOf<&Panel::b>(),
                                        &propertyOf<&Panel::c>()};
        for (std::size_t k = 0; k < 3; ++k)
            if (const int corner = m_system.panels[panel].corner[k]; m_twins.contains(corner))
                set(edit, *corners[k], Id{m_system.panelKey[panel]}, particleId(corner));
    }

    Draft& m_draft;
    Scene& m_scene;
    const System& m_system;
    TwinOrigins m_origins;
    std::map<int, Id> m_twins;             // rows of particles
    std::map<std::size_t, Id> m_twinLinks; // rows of links
    std::map<Key, Id> m_parted;
    std::map<Id, std::pair<RemoveRows, AddRows>> m_rows; // of each part
    std::map<Key, int> m_halved;                         // links that there are two of
    std::unordered_map<Key, LinkRow> m_links;
};

// Ids of the rows of what a frame has, once twins have rows of their own.
struct RowIds
{
    std::vector<Id> particles; // [particles]
    std::vector<Id> links;     // [links]
};

RowIds rowIds(Draft& draft, const Layout& layout)
{
    RowIds ids;
    if (layout.torn) {
        SplitWriter split(draft, *layout.torn);
        split.write();
        for (std::size_t i = 0; i < layout.particleId.size(); ++i)
            ids.particles.push_back(split.particleId(int(i)));
        for (std::size_t i = 0; i < layout.links.size(); ++i)
            ids.links.push_back(split.linkId(i));
        return ids;
    }
    for (const std::uint32_t id : layout.particleId)
        ids.particles.push_back(Id{id});
    for (const Layout::Link& link : layout.links)
        ids.links.push_back(Id{link.id});
    return ids;
}

void place(Draft& draft, const Frame& frame, const RowIds& ids, const PoseOptions& options)
{
    std::unordered_map<Id, std::size_t> index;
    for (std::size_t i = 0; i < ids.particles.size(); ++i)
        index.emplace(ids.particles[i], i);
    SetValues positions{&propertyOf<&Particle::position>(), {}, {}};
    SetValues velocities{&propertyOf<&Particle::velocity>(), {}, {}};
    SetValues pins{&propertyOf<&Particle::pinned>(), {}, {}};
    const auto& handPins = frame.handPins;
    forEachPart(draft.posed.scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const auto found = index.find(particle.id);
            if (found == index.end())
                continue;
            const std::size_t i = found->second;
            positions.targets.push_back(particle.id);
            positions.values.emplace_back(frame.position[i]);
            velocities.targets.push_back(particle.id);
            velocities.values.emplace_back(options.keepsMotion ? frame.velocity[i]
                                                               : Vec3(Vec3::Zero()));
            if (std::find(handPins.begin(), handPins.end(), frame.layout->keyOf(i))
                != handPins.end())
                pins.targets.push_back(particle.id);
        }
    });
    if (positions.targets.empty())
        return;
    pins.values.emplace_back(true);
    Edit edit{{}, {std::move(positions), std::move(velocities)}};
    if (!pins.targets.empty())
        edit.changes.emplace_back(std::move(pins));
    draft.make(std::move(edit));
}

void placeColliders(Draft& draft, const Frame& frame)
{
    SetValues places{&propertyOf<&Collider::position>(), {}, {}};
    for (const Carry& carry : frame.carries)
        if (const auto* collider = findItem<Collider>(draft.posed.scene, Id{carry.collider})) {
            places.targets.push_back(Id{carry.collider});
            places.values.emplace_back(Vec3(collider->position + carry.way));
        }
    if (!places.targets.empty())
        draft.make({{}, {std::move(places)}});
}

void removeTorn(Draft& draft, const Frame& frame, const RowIds& ids)
{
    std::vector<Id> gone;
    for (std::size_t i = 0; i < frame.torn.size(); ++i)
        if (frame.torn[i])
            gone.push_back(ids.links[i]);
    for (std::size_t i = 0; i < frame.gone.size(); ++i)
        if (frame.gone[i])
            gone.push_back(Id{frame.layout->panelId[i]});
    if (!gone.empty())
        draft.make(removal(draft.posed.scene, gone));
}

void rebind(Draft& draft)
{
    std::unordered_map<Id, Vec3> place;
    forEachPart(draft.posed.scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            place.emplace(particle.id, particle.position);
    });
    SetValues lengths{&propertyOf<&Link::restLength>(), {}, {}};
    forEachPart(draft.posed.scene, [&](Id, const Part& part) {
        for (const Link& link : part.links) {
            lengths.targets.push_back(link.id);
            lengths.values.emplace_back((place[link.to] - place[link.from]).norm());
        }
    });
    if (!lengths.targets.empty())
        draft.make({{}, {std::move(lengths)}});
}

} // namespace

std::size_t partedParticles(const Layout& layout)
{
    return layout.torn ? layout.torn->splits.size() : 0;
}

Posed posed(Scene scene, const Frame& frame, const PoseOptions& options)
{
    Draft draft{{std::move(scene), {Message("Adopt pose"), {}}}};
    const RowIds ids = rowIds(draft, *frame.layout);
    place(draft, frame, ids, options);
    placeColliders(draft, frame);
    removeTorn(draft, frame, ids);
    if (options.rebindsLengths)
        rebind(draft);
    return std::move(draft.posed);
}

} // namespace ripstop
