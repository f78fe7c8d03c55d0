// Of each part whose panels carry its pull: panels without area, threads that carry it as well, and
// materials that carry nothing, are unstable or tear by a rule that no panel has.
#include "check/elastic_check.h"

#include "derived/flat_panel.h"
#include "derived/panel_fabric.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

constexpr double stiffest = 1e10; // N/m, of panels; steel of 50 mm
constexpr double nearlyUnstable = 0.98;

// What of the tear rule of a material does not hold for panels.
void checkTear(const Part& part, Id id, const Material& material, const AddFinding& add)
{
    const auto warn = [&](const Message& message) { add("whole", Severity::Warning, message, id); };
    switch (material.tearRule) {
    case TearRule::Length:
    case TearRule::Force:
        warn(Message("Panels of %1 do not tear: %2 tears by length or force, which are of links. "
                     "Choose tension, strength or strain.",
                     part.name, material.name));
        break;
    case TearRule::Strength:
        if (!material.warpStrength && !material.weftStrength)
            warn(Message("Panels of %1 do not tear: %2 tears by strength, and has none along its "
                         "warp or across it. Type its warp and weft strength.",
                         part.name, material.name));
        else if (!material.warpStrength)
            warn(Message("Panels of %1 do not tear along the warp of %2, which tears by strength "
                         "and has no warp strength: type it.",
                         part.name, material.name));
        else if (!material.weftStrength)
            warn(Message("Panels of %1 do not tear across the warp of %2, which tears by strength "
                         "and has no weft strength: type it.",
                         part.name, material.name));
        break;
    case TearRule::Energy:
        if (!material.tearStrength)
            warn(Message("Tears in panels of %1 go on by its strengths: %2 tears by energy and has "
                         "no tear strength. Type it, or choose strength.",
                         part.name, material.name));
        break;
    case TearRule::Never:
    case TearRule::Strain:
    case TearRule::Tension:
        break;
    }
}

void checkMaterial(const Part& part, Id partId, Id id, const Material* material,
                   const AddFinding& add)
{
    if (!material) {
        add("limp", Severity::Warning,
            Message("Panels of %1 are to carry its pull and have no material: they carry nothing.",
                    part.name),
            partId);
        return;
    }
    if (!material->membraneStiffness) {
        add("limp", Severity::Warning,
            Message("Panels of %1 are to carry its pull, and %2 has no membrane stiffness: they "
                    "carry nothing.",
                    part.name, material->name),
            id);
        return;
    }
    checkTear(part, id, *material, add);
    const double warp = *material->membraneStiffness;
    const double weft = material->weftStiffness.value_or(warp);
    if (std::max({warp, weft, material->shearStiffness.value_or(0.0)}) > stiffest)
        add("stiffest", Severity::Error,
            Message("Material %1 has panels stiffer than %2 N/m, which no step can solve and no "
                    "fabric is: check the unit.",
                    material->name, Message::number("%.0e", stiffest)),
            id);
    if (!(material->poissonRatio * material->poissonRatio * weft < nearlyUnstable * warp))
        add("poisson", Severity::Error,
            Message("Material %1 would get energy out of being strained: its Poisson's ratio must "
                    "be below %2, the root of warp over weft stiffness.",
                    material->name,
                    Message::number("%.3g", std::sqrt(nearlyUnstable * warp / weft))),
            id);
}

void checkPart(const Scene& scene, const ElementIndex& index, const std::vector<const Vec3*>& place,
               Id id, const Part& part, const AddFinding& add)
{
    std::set<Id> materials;
    for (const Panel& row : part.panels) {
        const int a = index.particle(row.a), b = index.particle(row.b), c = index.particle(row.c);
        if (std::min({a, b, c}) < 0)
            continue;
        materials.insert(row.material);
        if (!flatPanel(row, *place[std::size_t(a)], *place[std::size_t(b)], *place[std::size_t(c)]))
            add("flat", Severity::Error,
                Message("Panel %1 of %2 has no area at rest, and its part has panels carry the "
                        "pull: change its rest lengths, or remove it.",
                        std::uint32_t(row.id), part.name),
                row.id);
    }
    const auto threads = std::ranges::count_if(part.links, isOfFabric);
    if (threads > 0)
        add("both", Severity::Warning,
            Message("%1 has panels that carry the pull of its fabric and %2 threads that carry it "
                    "as well: remove the threads, or have threads carry it.",
                    part.name, std::size_t(threads)),
            id);
    for (const Id used : materials)
        checkMaterial(part, id, used, findItem<Material>(scene, used), add);
}

} // namespace

void checkElasticPanels(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    std::vector<const Vec3*> place; // [particles]
    const auto carries = [](const Part& part) { return part.carrier == FabricKind::Panels; };
    bool any = false;
    forEachPart(scene, [&](Id, const Part& part) { any |= carries(part); });
    if (!any)
        return;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& particle : part.particles)
            place.push_back(&particle.position);
    });
    forEachPart(scene, [&](Id id, const Part& part) {
        if (carries(part))
            checkPart(scene, index, place, id, part, add);
    });
}

} // namespace ripstop
