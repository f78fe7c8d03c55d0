#include "compile/live_system.h"

#include "compile/compile.h"

#include <algorithm>

namespace ripstop {
namespace {

// Whether the property says who is joined to whom and by what.
bool isStructure(const Property& property)
{
    const auto is = [&](auto... keys) { return ((property.key == keys) || ...); };
    return (property.kind == Kind::Link && is("from", "to", "kind"))
           || (property.kind == Kind::Wind && is("kind")) // the states of gusts
           || (property.kind == Kind::Panel && is("a", "b", "c"))
           || (property.kind == Kind::Part && is("canopyPressure")); // the states of its air
}

// Whether some fabric holds air. Its shape hangs on where particles start and on rest lengths, so
// it is found anew rather than patched.
bool hasCanopies(const Scene& scene)
{
    bool some = false;
    forEachPart(scene, [&](Id, const Part& part) { some |= part.canopyPressure > 0.0; });
    return some;
}

// A plot comes or goes, which no system knows of.
bool isPlot(const Scene& scene, const Change& change)
{
    if (const auto* added = std::get_if<AddItem>(&change))
        return std::holds_alternative<Plot>(added->entry.item);
    const auto* removed = std::get_if<RemoveItem>(&change);
    return removed && findItem<Plot>(scene, removed->id);
}

void add(std::vector<Id>& list, const std::vector<Id>& ids)
{
    list.insert(list.end(), ids.begin(), ids.end());
}

void sortOnce(std::vector<Id>& ids)
{
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

template <typename Row>
const Row& rowOf(const Scene& scene, Id id)
{
    return *std::get<const Row*>(*find(scene, id));
}

} // namespace

LiveSystem::LiveSystem(Scene scene)
    : m_scene(std::move(scene))
{}

void LiveSystem::replace(Scene scene)
{
    m_scene = std::move(scene);
    m_noted = {};
}

void LiveSystem::apply(const Edit& edit)
{
    for (const Change& change : edit.changes)
        if (const auto* values = std::get_if<SetValues>(&change))
            note(*values);
        else if (isPlot(m_scene, change))
            m_noted.probes = true; // which it names
        else
            m_noted.structure = true;
    (void)ripstop::apply(m_scene, edit);
}

void LiveSystem::note(const SetValues& change)
{
    const Property& property = *change.property;
    // names and the like; those of probes stand in the system, and plots name probes
    const bool isAboutProbes =
        property.kind == Kind::Probe || (property.kind == Kind::Plot && !property.pointsAt.empty());
    if (property.effect == Effect::DisplayOnly && !isAboutProbes)
        return;
    const bool shapes = property.kind == Kind::Particle || property.kind == Kind::Link
                        || property.kind == Kind::Part;
    if (isStructure(property) || (shapes && hasCanopies(m_scene)))
        m_noted.structure = true;
    if (m_noted.structure)
        return;
    switch (property.kind) {
    case Kind::Settings:
        m_noted.settings = true;
        break;
    case Kind::Particle:
        add(m_noted.particles, change.targets);
        break;
    case Kind::Link:
        add(m_noted.links, change.targets);
        break;
    case Kind::Panel:
        add(m_noted.panels, change.targets);
        break;
    case Kind::Material:
        add(m_noted.materials, change.targets);
        break;
    case Kind::Collider:
        m_noted.obstacles = true;
        break;
    case Kind::Wind:
        m_noted.wind = true;
        break;
    case Kind::Control:
        m_noted.inputs = true;
        break;
    case Kind::Group:
    case Kind::Probe:
    case Kind::Plot:
        m_noted.probes = true;
        break;
    case Kind::Part:
        m_noted.fabricLayers = true;
        break;
    }
}

std::variant<Update, Finding> LiveSystem::update(std::uint64_t generation, std::uint64_t run)
{
    for (std::vector<Id>* ids :
         {&m_noted.materials, &m_noted.particles, &m_noted.links, &m_noted.panels})
        sortOnce(*ids);
    if (m_noted.structure)
        m_index = ElementIndex(m_scene);
    if (m_noted.structure || !isSound())
        if (std::optional<Finding> error = firstError(m_scene, m_index))
            return std::move(*error);

    Update update;
    if (m_noted.structure) {
        const std::shared_ptr<System> system = m_memory.take();
        system->generation = generation;
        system->run = run;
        compileSound(m_scene, m_index, *system);
        update.system = system;
    } else {
        Patch made = patch();
        made.generation = generation;
        made.run = run;
        update.patch = std::make_shared<const Patch>(std::move(made));
    }
    m_noted = {};
    m_noted.structure = false;
    return update;
}

// Whether what was noted has no error; all else had none at the last update.
bool LiveSystem::isSound() const
{
    const auto sound = [&](Id id) { return ripstop::isSound(*find(m_scene, id), m_index); };
    const bool items = m_noted.obstacles || m_noted.wind || m_noted.inputs || m_noted.probes;
    return std::all_of(m_noted.particles.begin(), m_noted.particles.end(), sound)
           && std::all_of(m_noted.links.begin(), m_noted.links.end(), sound)
           && std::all_of(m_noted.panels.begin(), m_noted.panels.end(), sound)
           && !(items && firstErrorOfItems(m_scene, m_index));
}

Patch LiveSystem::patch() const
{
    Patch patch;
    if (m_noted.settings)
        patch.settings = m_scene.settings;
    if (m_noted.wind)
        patch.winds = windsOf(m_scene);
    if (m_noted.fabricLayers)
        patch.fabricLayers = fabricLayersOf(m_scene);
    if (m_noted.obstacles)
        patch.obstacles = obstaclesOf(m_scene);
    if (m_noted.inputs)
        patch.inputs = inputsOf(m_scene, m_index);
    if (m_noted.probes)
        patch.probes = probesOf(m_scene, m_index);
    for (const Id id : m_noted.materials)
        patch.materials.emplace_back(Key(id), materialOf(m_scene, m_index, id));
    for (const Id id : m_noted.particles)
        patch.particles.emplace_back(m_index.particle(id), valuesOf(rowOf<Particle>(m_scene, id)));
    for (const Id id : m_noted.links)
        patchLink(id, patch);
    for (const Id id : m_noted.panels)
        patchPanel(id, patch);
    return patch;
}

void LiveSystem::patchLink(Id id, Patch& patch) const
{
    const Link& row = rowOf<Link>(m_scene, id);
    const Material& material = materialOf(m_scene, m_index, row.material);
    const int link = m_index.link(id);
    const int a = m_index.particle(row.from);
    const int b = m_index.particle(row.to);
    patch.linkStuff.emplace_back(link, stuffOf(row));
    if (row.kind == LinkKind::Spring)
        patch.springs.emplace_back(link, springOf(row, material, a, b));
    else
        patch.rods.emplace_back(link, rodOf(row, material, a, b));
}

void LiveSystem::patchPanel(Id id, Patch& patch) const
{
    const Panel& row = rowOf<Panel>(m_scene, id);
    patch.panels.emplace_back(m_index.panel(id), Key(row.material));
}

} // namespace ripstop
