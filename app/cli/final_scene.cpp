#include "cli/final_scene.h"

#include "scene/edit.h"
#include "sim/split_system.h"

#include <map>
#include <unordered_map>

namespace ripstop {
namespace {

// Makes rows of what tears have doubled, and lets rows end where they end now.
class SplitWriter
{
public:
    SplitWriter(Scene& scene, const Simulation& simulation)
        : m_scene(scene)
        , m_system(simulation.system())
        , m_origins(simulation.state().splits)
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
        Edit edit{"Split", {}};
        for (auto& [part, rows] : m_rows) {
            edit.changes.emplace_back(std::move(rows.first));
            edit.changes.emplace_back(std::move(rows.second));
        }
        for (std::size_t i = 0; i < m_system.panels.size(); ++i)
            writePanel(i, edit);
        (void)apply(m_scene, edit);
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

    static void set(Edit& edit, Kind kind, const char* key, Id target, Value value)
    {
        edit.changes.emplace_back(SetValues{findProperty(kind, key), {target}, {std::move(value)}});
    }

    void addParticles()
    {
        std::map<Key, std::pair<Id, Particle>> rows;
        forEachPart(m_scene, [&](Id id, const Part& part) {
            for (const Particle& row : part.particles)
                rows[Key(row.id)] = {id, row};
        });
        Edit edit{"Split", {}};
        for (std::size_t i = 0; i < m_system.key.size(); ++i) {
            if (m_system.key[i] < firstTwinParticle)
                continue;
            const Key origin = m_origins.particle(m_system.key[i]);
            auto [part, row] = rows[origin];
            row.id = takeId(m_scene);
            row.mass = m_system.mass[i];
            row.pinned = false;
            m_twins[int(i)] = row.id;
            m_parted.insert_or_assign(origin, row.id);
            edit.changes.emplace_back(AddRows{part, {row}, {}, {}});
        }
        for (std::size_t i = 0; i < m_system.key.size(); ++i)
            if (m_parted.contains(m_system.key[i]))
                set(edit, Kind::Particle, "mass", Id{m_system.key[i]}, m_system.mass[i]);
        (void)apply(m_scene, edit);
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
            const bool spring = link.kind == LinkKind::Spring;
            const TearLimit& tear =
                spring ? m_system.springs[index].tear : m_system.rods[index].tear;
            if (spring) {
                row.stiffness = m_system.springs[index].stiffness;
                row.damping = m_system.springs[index].damping;
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
        const char* const names[]{"a", "b", "c"};
        for (std::size_t k = 0; k < 3; ++k)
            if (const int corner = m_system.panels[panel].corner[k]; m_twins.contains(corner))
                set(edit, Kind::Panel, names[k], Id{m_system.panelKey[panel]}, particleId(corner));
    }

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

} // namespace

Scene finalScene(Scene scene, const Simulation& simulation)
{
    const std::shared_ptr<const Frame> frame = simulation.frame();
    const System& system = simulation.system();
    SplitWriter split(scene, simulation);
    if (!simulation.state().splits.empty())
        split.write();

    std::unordered_map<Id, std::size_t> index;
    for (std::size_t i = 0; i < system.key.size(); ++i)
        index.emplace(split.particleId(int(i)), i);
    SetValues positions{findProperty(Kind::Particle, "position"), {}, {}};
    SetValues velocities{findProperty(Kind::Particle, "velocity"), {}, {}};
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const auto found = index.find(particle.id);
            if (found == index.end())
                continue;
            positions.targets.push_back(particle.id);
            positions.values.emplace_back(frame->position[found->second]);
            velocities.targets.push_back(particle.id);
            velocities.values.emplace_back(frame->velocity[found->second]);
        }
    });

    std::vector<Id> gone;
    for (std::size_t i = 0; i < system.links.size(); ++i)
        if (frame->torn[i])
            gone.push_back(split.linkId(i));
    for (std::size_t i = 0; i < system.panelKey.size(); ++i)
        if (frame->gone[i])
            gone.push_back(Id{system.panelKey[i]});

    if (!positions.targets.empty())
        (void)apply(scene, {"Adopt pose", {std::move(positions), std::move(velocities)}});
    (void)apply(scene, removal(scene, gone));
    return scene;
}

} // namespace ripstop
