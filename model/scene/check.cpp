#include "scene/check.h"

#include "base/step_limit.h"
#include "scene/property.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <unordered_map>
#include <unordered_set>

namespace ripstop {
namespace {

// As the subject of a sentence.
std::string named(Kind kind, Id id)
{
    std::string name(kindName(kind));
    name[0] = char(std::toupper(name[0]));
    return id == settingsId ? name : name + " " + std::to_string(std::uint32_t(id));
}

class Checker
{
public:
    Checker(const Scene& scene, std::size_t most)
        : m_scene(scene)
        , m_most(most)
    {}

    std::vector<Problem> run()
    {
        index();
        references();
        masses();
        shapes();
        duplicates();
        stability();
        if (m_particles.empty())
            add("empty", Severity::Warning,
                "The scene has no particles: insert a part or import a mesh.", noId);
        std::stable_sort(
            m_problems.begin(), m_problems.end(),
            [](const Problem& a, const Problem& b) { return a.severity < b.severity; });
        return std::move(m_problems);
    }

private:
    void add(const char* sort, Severity severity, std::string message, Id culprit)
    {
        if (++m_count[sort] <= m_most)
            m_problems.push_back({severity, std::move(message), culprit});
    }

    void index()
    {
        for (const Entry& entry : m_scene.items) {
            note(entry.id,
                 std::visit([](const auto& i) { return kindOf(ConstRef(&i)); }, entry.item));
            if (const Part* part = std::get_if<Part>(&entry.item)) {
                for (const Particle& row : part->particles) {
                    note(row.id, Kind::Particle);
                    m_particles.emplace(row.id, &row);
                }
                for (const Link& row : part->links)
                    note(row.id, Kind::Link);
                for (const Panel& row : part->panels)
                    note(row.id, Kind::Panel);
            }
        }
    }

    void note(Id id, Kind kind)
    {
        if (!m_kinds.emplace(id, kind).second)
            add("twice", Severity::Error,
                "The id " + std::to_string(std::uint32_t(id))
                    + " is used twice; give one of the two another id.",
                id);
    }

    void pointing(Id holder, const ConstRef& ref)
    {
        for (const Property& property : propertiesOf(kindOf(ref))) {
            if (property.pointsAt.empty())
                continue;
            const auto check = [&](Id id) {
                const auto found = m_kinds.find(id);
                if (found == m_kinds.end() || !property.pointsAt.contains(found->second))
                    add("dangling", Severity::Error,
                        named(kindOf(ref), holder) + ": " + std::string(property.key)
                            + " points at " + std::to_string(std::uint32_t(id))
                            + (found == m_kinds.end()
                                   ? ", which does not exist; choose another or remove it."
                                   : ", which is a " + std::string(kindName(found->second)) + "."),
                        holder);
            };
            const Value value = property.get(ref);
            if (const Id* id = std::get_if<Id>(&value); id && *id != noId)
                check(*id);
            if (const auto* ids = std::get_if<std::vector<Id>>(&value))
                for (const Id member : *ids) // a list has no place for nothing
                    check(member);
        }
    }

    void references()
    {
        for (const Entry& entry : m_scene.items) {
            std::visit([&](const auto& item) { pointing(entry.id, &item); }, entry.item);
            if (const Part* part = std::get_if<Part>(&entry.item)) {
                for (const Link& row : part->links) {
                    pointing(row.id, &row);
                    if (row.from == noId || row.to == noId || row.from == row.to)
                        add("ends", Severity::Error,
                            named(Kind::Link, row.id)
                                + " needs two different particles as its ends; remove it.",
                            row.id);
                }
                for (const Panel& row : part->panels) {
                    pointing(row.id, &row);
                    if (row.a == noId || row.b == noId || row.c == noId || row.a == row.b
                        || row.b == row.c || row.a == row.c)
                        add("corners", Severity::Error,
                            named(Kind::Panel, row.id)
                                + " needs three different particles as its corners; remove it.",
                            row.id);
                }
            }
        }
    }

    void masses()
    {
        for (const Entry& entry : m_scene.items)
            if (const Part* part = std::get_if<Part>(&entry.item))
                for (const Particle& row : part->particles)
                    if (!row.pinned && !(row.mass > 0.0))
                        add("massless", Severity::Error,
                            named(Kind::Particle, row.id) + " of " + part->name
                                + " is free and has no mass: give it a mass or pin it.",
                            row.id);
    }

    void shapes()
    {
        for (const Entry& entry : m_scene.items) {
            if (const Collider* collider = std::get_if<Collider>(&entry.item))
                if (collider->shape == ColliderShape::Plane && !(collider->normal.norm() > 0.0))
                    add("normal", Severity::Error,
                        "Collider " + collider->name + " needs a normal that is not zero.",
                        entry.id);
            if (const Control* control = std::get_if<Control>(&entry.item)) {
                if (!(control->axis.norm() > 0.0))
                    add("axis", Severity::Error,
                        "Control " + control->name + " needs an axis that is not zero.", entry.id);
                if (control->targets.empty())
                    add("idle", Severity::Warning,
                        "Control " + control->name + " has no targets and does nothing.", entry.id);
            }
            if (const Probe* probe = std::get_if<Probe>(&entry.item))
                if ((probe->quantity == Quantity::Distance
                     || probe->quantity == Quantity::Elevation)
                    && (probe->target == noId || probe->from == noId))
                    add("probe", Severity::Warning,
                        "Probe " + probe->name + " needs a target and a particle to measure from.",
                        entry.id);
        }
    }

    void duplicates()
    {
        std::unordered_set<std::uint64_t> seen;
        std::unordered_set<Id> tied;
        for (const Entry& entry : m_scene.items)
            if (const Part* part = std::get_if<Part>(&entry.item))
                for (const Link& row : part->links) {
                    tied.insert(row.from);
                    tied.insert(row.to);
                    const auto low = std::uint64_t(std::min(row.from, row.to));
                    const auto high = std::uint64_t(std::max(row.from, row.to));
                    if (!seen.insert(low << 32 | high).second)
                        add("double", Severity::Warning,
                            named(Kind::Link, row.id) + " of " + part->name
                                + " joins two particles that are joined already.",
                            row.id);
                }
        for (const Entry& entry : m_scene.items)
            if (const Part* part = std::get_if<Part>(&entry.item))
                for (const Particle& row : part->particles)
                    if (!tied.contains(row.id) && !row.pinned && !part->links.empty())
                        add("loose", Severity::Warning,
                            named(Kind::Particle, row.id) + " of " + part->name
                                + " has no links and will fly by itself.",
                            row.id);
    }

    void stability()
    {
        const std::optional<StepLimit> limit = stepLimit(m_scene);
        const double h = m_scene.settings.timeStep / m_scene.settings.substeps;
        if (!limit || h <= limit->timeStep)
            return;
        char text[200];
        std::snprintf(
            text, sizeof text,
            "The substep of %.3g s is above the %.3g s that the springs at particle %u may "
            "need: shorten the time step, add substeps, or lower stiffness and damping.",
            h, limit->timeStep, unsigned(limit->particle));
        add("step", Severity::Warning, text, limit->particle);
    }

    const Scene& m_scene;
    std::size_t m_most;
    std::unordered_map<Id, Kind> m_kinds;
    std::unordered_map<Id, const Particle*> m_particles;
    std::unordered_map<std::string, std::size_t> m_count;
    std::vector<Problem> m_problems;
};

} // namespace

std::vector<Problem> problemsOf(const Scene& scene, std::size_t most)
{
    return Checker(scene, most).run();
}

bool hasErrors(const std::vector<Problem>& problems)
{
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& p) { return p.severity == Severity::Error; });
}

std::optional<StepLimit> stepLimit(const Scene& scene)
{
    struct Sums
    {
        double stiffness = 0.0; // N/m
        double damping = 0.0;   // N s/m
    };
    std::unordered_map<Id, Sums> springsAt;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& link : part.links) {
            if (link.kind != LinkKind::Spring)
                continue;
            const Material* material = findItem<Material>(scene, link.material);
            for (const Id end : {link.from, link.to}) {
                Sums& sums = springsAt[end];
                sums.stiffness += link.stiffness.value_or(material ? material->stiffness : 0.0);
                sums.damping += link.damping.value_or(material ? material->damping : 0.0);
            }
        }
    });
    std::optional<StepLimit> limit;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles) {
            const auto sums = springsAt.find(particle.id);
            if (particle.pinned || sums == springsAt.end())
                continue;
            const double h =
                springStepLimit(particle.mass, sums->second.stiffness, sums->second.damping);
            if (std::isfinite(h) && (!limit || h < limit->timeStep))
                limit = StepLimit{h, particle.id};
        }
    });
    return limit;
}

} // namespace ripstop
