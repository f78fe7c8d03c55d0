// One finding of a kind for each material of a part, which names its longest cells; and one for
// each part whose panels were all given one grain.
#include "check/thread_check.h"

#include "derived/lattice_stiffness.h"
#include "derived/link_stiffness.h"
#include "derived/panel_fabric.h"
#include "derived/scattered_warps.h"

#include <algorithm>
#include <map>

namespace ripstop {
namespace {

constexpr double noticed = 1.05; // of the membrane stiffness
// Of meshes, which no one draws to the last percent, and sails taper.
constexpr double offGrid = 1.1;  // of the membrane stiffness
constexpr double offShear = 1.5; // of the shear stiffness

bool followsMaterial(const Link& link)
{
    return link.role == LinkRole::Thread && isOfFabric(link)
           && !(link.kind == LinkKind::Rod ? link.compliance : link.stiffness);
}

// Of a mesh whose threads are no lines along warp and weft.
void checkLattice(const Part& part, Id id, const Material& material, const LatticeStiffness& given,
                  const AddFinding& add)
{
    const double wanted = *material.membraneStiffness;
    const bool pullsRight = given.along < offGrid * wanted && wanted < offGrid * given.along;
    const bool shearsRight =
        !material.shearStiffness || given.shear < offShear * *material.shearStiffness;
    if (pullsRight && shearsRight)
        return;
    const auto number = [](double value) { return Message::number("%.3g N/m", value); };
    add("lattice", Severity::Warning,
        material.shearStiffness
            ? Message("Threads of %1 pull with %2 at most, with less along lines that zigzag, and "
                      "resist shear with up to %3, where %4 has %5 and %6: they are true along "
                      "warp and weft of a grid of quads, and this mesh is another. Have panels "
                      "carry the pull.",
                      part.name, number(given.along), number(given.shear), material.name,
                      number(wanted), number(*material.shearStiffness))
            : Message(
                "Threads of %1 pull with %2 at most, with less along lines that zigzag, where "
                "%3 has %4: they are true along warp and weft of a grid of quads, and this "
                "mesh is another. Have panels carry the pull.",
                part.name, number(given.along), material.name, number(wanted)),
        id);
}

// A thread does not say whether it is warp or weft.
void checkWeft(const Part& part, const Link& thread, const Material& material,
               const AddFinding& add)
{
    if (!material.membraneStiffness || !material.weftStiffness)
        return;
    const double warp = *material.membraneStiffness;
    const double weft = *material.weftStiffness;
    if (std::max(warp, weft) <= noticed * std::min(warp, weft))
        return;
    add("weft", Severity::Warning,
        Message("Threads of %1 pull with the membrane stiffness of %2, %3, whichever way they run; "
                "its weft stiffness of %4 is not used. Have panels carry the pull, which know warp "
                "and weft.",
                part.name, material.name, Message::number("%.0f N/m", warp),
                Message::number("%.0f N/m", weft)),
        thread.id);
}

void checkWarps(const Scene& scene, const AddFinding& add)
{
    for (const ScatteredWarps& warps : scatteredWarps(scene))
        add("scattered warps", Severity::Warning,
            Message("All panels of %1 have the grain %2 degrees, which each counts from its own "
                    "side ab, so that warps lie up to %3 degrees apart. For one direction on the "
                    "cloth map the grain by a formula, paint it with the brush, or import the mesh "
                    "with the warp turned.",
                    findItem<Part>(scene, warps.part)->name, Message::number("%.4g", warps.grain),
                    Message::number("%.0f", warps.apart)),
            warps.part);
}

} // namespace

void checkThreads(const Scene& scene, const AddFinding& add)
{
    checkWarps(scene, add);
    forEachPart(scene, [&](Id, const Part& part) {
        std::map<Id, const Link*> longest; // of each material
        for (const Link& link : part.links)
            if (followsMaterial(link)) {
                const Link*& most = longest.try_emplace(link.material, &link).first->second;
                if (link.cellAspect > most->cellAspect)
                    most = &link;
            }
        std::map<Id, const Material*> materials; // of the links of fabric
        if (!longest.empty())
            for (const Entry& entry : scene.items)
                if (const Material* material = std::get_if<Material>(&entry.item))
                    materials[entry.id] = material;
        const auto given = latticeStiffness(part, materials);
        for (const auto& [id, link] : longest) {
            const auto* const material = findItem<Material>(scene, id);
            if (material)
                checkWeft(part, *link, *material, add);
            const auto modulus =
                material ? fabricModulus(*material, link->cellAspect) : std::nullopt;
            if (!modulus)
                continue;
            if (*modulus <= noticed * *material->membraneStiffness) {
                if (const auto found = given.find(id); found != given.end())
                    checkLattice(part, link->id, *material, found->second, add);
                continue;
            }
            add("aspect", Severity::Warning,
                Message("Threads of %1 pull with up to %2 along cells that are %3 times as long as "
                        "wide, instead of the membrane stiffness of %4, %5: their diagonals alone "
                        "are stiffer. Make the cells squarer, or have panels carry the pull.",
                        part.name, Message::number("%.0f N/m", *modulus),
                        Message::number("%.2g", link->cellAspect), material->name,
                        Message::number("%.0f N/m", *material->membraneStiffness)),
                link->id);
        }
    });
}

} // namespace ripstop
