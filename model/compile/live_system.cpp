// Edits are applied to the scene and what they touch is noted. An update then makes a new system
// where structure has changed, or else a patch that resolves again only what was noted, after
// checking it for errors.
#include "compile/live_system.h"

#include "check/step_limits.h"
#include "compile/compile.h"
#include "compile/patch.h"
#include "scene/element_index.h"
#include "system/system_memory.h"

#include <algorithm>

namespace ripstop {
namespace {

// Whether some fabric holds air. Its shape hangs on where particles start and on rest lengths, so
// it is found anew rather than patched.
bool hasCanopies(const Scene& scene)
{
    bool some = false;
    forEachPart(scene, [&](Id, const Part& part) { some |= part.canopyPressure > 0.0; });
    return some;
}

// Whether panels carry the pull of some fabric. That they can hangs on several things at once:
// where particles start, rest lengths, and the numbers of materials.
bool hasElasticPanels(const Scene& scene)
{
    bool some = false;
    forEachPart(scene, [&](Id, const Part& part) { some |= part.carrier == FabricKind::Panels; });
    return some;
}

// Whether where particles start says how some of these panels are cut: a side without a rest length
// has the distance of its corners.
bool startCutsPanels(const Scene& scene)
{
    bool some = false;
    forEachPart(scene, [&](Id, const Part& part) {
        some |= part.carrier == FabricKind::Panels
                && std::ranges::any_of(part.panels, [](const Panel& panel) {
                       return std::min({panel.restAB, panel.restBC, panel.restCA}) == 0.0;
                   });
    });
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

class LiveSystem::Private
{
public:
    explicit Private(Scene scene)
        : m_scene(std::move(scene))
    {}

    const Scene& scene() const { return m_scene; }
    void replace(Scene scene);
    void apply(const Edit& edit);
    std::variant<Update, Finding> update(std::uint64_t generation, std::uint64_t run);

private:
    struct Noted // since the last update
    {
        bool structure = true; // a new system is due
        bool settings = false;
        bool wind = false;
        bool obstacles = false;
        bool fabricLayers = false;
        bool inputs = false;
        bool probes = false;
        std::vector<Id> materials;
        std::vector<Id> particles;
        std::vector<Id> links;
        std::vector<Id> panels;
    };

    void note(const SetValues& change);
    bool isSound() const;
    bool movesSprings() const;
    Patch patch() const;
    void patchLink(Id id, Patch& patch) const;
    void patchPanel(Id id, Patch& patch) const;

    Scene m_scene;
    ElementIndex m_index; // of the scene when m_noted.structure is false
    Noted m_noted;
    bool m_springsTogether = false; // in what the last update has made
    SystemMemory m_memory;
};

LiveSystem::LiveSystem(Scene scene)
    : d(std::make_unique<Private>(std::move(scene)))
{}

LiveSystem::~LiveSystem() = default;

const Scene& LiveSystem::scene() const { return d->scene(); }

void LiveSystem::replace(Scene scene) { d->replace(std::move(scene)); }

void LiveSystem::apply(const Edit& edit) { d->apply(edit); }

std::variant<Update, Finding> LiveSystem::update(std::uint64_t generation, std::uint64_t run)
{
    return d->update(generation, run);
}

void LiveSystem::Private::replace(Scene scene)
{
    m_scene = std::move(scene);
    m_noted = {};
}

void LiveSystem::Private::apply(const Edit& edit)
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

void LiveSystem::Private::note(const SetValues& change)
{
    const Property& property = *change.property;
    // names and the like; those of probes stand in the system, and plots name probes
    const bool isAboutProbes =
        property.kind == Kind::Probe || (property.kind == Kind::Plot && !property.pointsAt.empty());
    if (property.effect == Effect::DisplayOnly && !isAboutProbes)
        return;
    const bool shapes = property.kind == Kind::Particle || property.kind == Kind::Link
                        || property.kind == Kind::Part;
    const bool moves = &property == &propertyOf<&Particle::position>();
    if (property.traits.contains(Trait::Structure) || (shapes && hasCanopies(m_scene))
        || (moves && startCutsPanels(m_scene)))
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

std::variant<Update, Finding> LiveSystem::Private::update(std::uint64_t generation,
                                                          std::uint64_t run)
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
    if (m_noted.structure || movesSprings()) {
        const std::shared_ptr<System> system = m_memory.take();
        system->generation = generation;
        system->run = run;
        compileSound(m_scene, m_index, *system);
        m_springsTogether = system->springsAsRods > 0;
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

// Whether springs go over to rods or come back from there. No patch knows of springs that are rods.
bool LiveSystem::Private::movesSprings() const
{
    const bool some = m_noted.settings || !m_noted.materials.empty() || !m_noted.particles.empty()
                      || !m_noted.links.empty();
    if (!some)
        return false;
    const auto isSpring = [this](Id id) {
        return rowOf<Link>(m_scene, id).kind == LinkKind::Spring;
    };
    return springsAreTogether(m_scene, m_index) != m_springsTogether
           || (m_springsTogether
               && (!m_noted.materials.empty() || std::ranges::any_of(m_noted.links, isSpring)));
}

// Whether what was noted has no error; all else had none at the last update.
bool LiveSystem::Private::isSound() const
{
    const auto sound = [&](Id id) { return ripstop::isSound(*find(m_scene, id), m_index); };
    const bool items = m_noted.obstacles || m_noted.wind || m_noted.inputs || m_noted.probes;
    const bool fabric =
        !m_noted.particles.empty() || !m_noted.panels.empty() || !m_noted.materials.empty();
    if (fabric && hasElasticPanels(m_scene) && firstError(m_scene, m_index))
        return false;
    return std::all_of(m_noted.particles.begin(), m_noted.particles.end(), sound)
           && std::all_of(m_noted.links.begin(), m_noted.links.end(), sound)
           && std::all_of(m_noted.panels.begin(), m_noted.panels.end(), sound)
           && !(items && firstErrorOfItems(m_scene, m_index));
}

Patch LiveSystem::Private::patch() const
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
        patch.particles.emplace_back(m_index.particle(id), rowOf<Particle>(m_scene, id));
    for (const Id id : m_noted.links)
        patchLink(id, patch);
    for (const Id id : m_noted.panels)
        patchPanel(id, patch);
    return patch;
}

void LiveSystem::Private::patchLink(Id id, Patch& patch) const
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

void LiveSystem::Private::patchPanel(Id id, Patch& patch) const
{
    const Panel& row = rowOf<Panel>(m_scene, id);
    patch.panels.emplace_back(m_index.panel(id), Key(row.material));
}

} // namespace ripstop
