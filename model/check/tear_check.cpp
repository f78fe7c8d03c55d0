#include "check/tear_check.h"

#include "derived/tear_bounds.h"

#include <set>
#include <utility>

namespace ripstop {
namespace {

// Biases hold the threads of a fabric in place; fabric tears by its threads.
bool cannotTear(const Link& link, const Material& material)
{
    return link.role != LinkRole::Bias
           && linkTearOf(material, link.role, link.width, link.tearLimit).rule == TearRule::Never;
}

// Links that bend are spars, and snap when they are bent too far.
bool isSpar(const Material& material)
{
    return isByStrength(material.tearRule)
           && (material.flexuralRigidity > 0.0 || material.breakingMoment);
}

Message unsnappable(const Part& part, const Material& material)
{
    return material.breakingMoment
               ? Message("Spars of %1 do not snap: %2 has a breaking moment and no flexural "
                         "rigidity, so that nothing resists bending. Type it.",
                         part.name, material.name)
               : Message("Spars of %1 do not snap: %2 tears by strength and has no breaking "
                         "moment. Type it, or choose another rule.",
                         part.name, material.name);
}

Message unbreakable(const Part& part, const Material& material, bool isLine)
{
    if (isByStrength(material.tearRule))
        return isLine ? Message("Lines of %1 do not tear: %2 tears by strength and has no line "
                                "strength. Type it, or choose another rule.",
                                part.name, material.name)
                      : Message("Threads of %1 do not tear: %2 tears by strength, and a thread "
                                "does not say whether it is warp or weft. Have panels carry the "
                                "pull, or choose tension.",
                                part.name, material.name);
    return isLine ? Message("Lines of %1 do not tear: %2 tears by its tension per width, and a "
                            "line has no width. Choose force.",
                            part.name, material.name)
                  : Message("Threads of %1 do not tear: %2 tears by its tension per width, and "
                            "some have no width. Type it, or choose force.",
                            part.name, material.name);
}

} // namespace

void checkTearing(const Scene& scene, const AddFinding& add)
{
    forEachPart(scene, [&](Id, const Part& part) {
        std::set<std::pair<Id, bool>> told; // material, whether of lines
        for (const Link& link : part.links) {
            const Material* material = findItem<Material>(scene, link.material);
            if (!material
                || (material->tearRule != TearRule::Tension && !isByStrength(material->tearRule)))
                continue;
            const bool isLine = link.role == LinkRole::Line;
            if (isSpar(*material) && isLine) {
                if (!(material->flexuralRigidity > 0.0 && snapMomentOf(*material) > 0.0)
                    && told.emplace(link.material, true).second)
                    add("unsnappable", Severity::Warning, unsnappable(part, *material),
                        link.material);
            } else if (cannotTear(link, *material) && told.emplace(link.material, isLine).second)
                add("unbreakable", Severity::Warning, unbreakable(part, *material, isLine),
                    link.material);
        }
    });
}

} // namespace ripstop
