#include "check/strength_gaps.h"

#include "scene/usage.h"

namespace ripstop {
namespace {

bool lacksStrength(const Material& material, const Use& made)
{
    const bool isFabric = made.threads > 0 || made.elasticPanels > 0;
    const bool hasLimit = material.tearRule == TearRule::Force;
    const bool hasLimitOfFabric = material.tearRule == TearRule::Tension;
    return (made.lines > 0 && !material.lineStrength && !material.breakingMoment && !hasLimit)
           || (isFabric && !material.warpStrength && !material.weftStrength && !hasLimitOfFabric);
}

bool outlastsStrength(const Material& material, const Use& made)
{
    const bool isFabric = made.threads > 0 || made.elasticPanels > 0;
    const bool isStrongLine = material.lineStrength || material.breakingMoment;
    const bool isStrongFabric = material.warpStrength || material.weftStrength;
    return material.tearRule == TearRule::Never
           && ((made.lines > 0 && isStrongLine) || (isFabric && isStrongFabric));
}

// In the order of the scene.
std::vector<Id> usedMaterials(const Scene& scene, const Usage& usage,
                              bool (*isMeant)(const Material&, const Use&))
{
    std::vector<Id> meant;
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item))
            if (const auto made = usage.ofMaterial.find(entry.id);
                made != usage.ofMaterial.end() && isMeant(*material, made->second))
                meant.push_back(entry.id);
    return meant;
}

} // namespace

std::vector<Id> materialsWithoutStrength(const Scene& scene)
{
    const Usage usage = usageOf(scene);
    std::vector<Id> without = usedMaterials(scene, usage, lacksStrength);
    const auto bare = usage.ofMaterial.find(noId);
    if (bare != usage.ofMaterial.end() && lacksStrength(Material(), bare->second))
        without.push_back(noId);
    return without;
}

std::vector<Id> materialsThatNeverTear(const Scene& scene)
{
    return usedMaterials(scene, usageOf(scene), outlastsStrength);
}

bool understatesOpening(const Scene& scene)
{
    bool holdsAir = false;
    forEachPart(scene, [&](Id, const Part& part) { holdsAir |= part.canopyPressure > 0.0; });
    return holdsAir && scene.settings.safetyFactor < openingSafetyFactor;
}

} // namespace ripstop
