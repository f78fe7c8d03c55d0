#include "materials/cloths.h"

#include "scene/usage.h"

namespace ripstop {

std::vector<Id> clothMaterials(const Scene& scene)
{
    const Usage usage = usageOf(scene);
    std::vector<Id> cloths;
    for (const Entry& entry : scene.items) {
        const auto use = usage.ofMaterial.find(entry.id);
        if (std::holds_alternative<Material>(entry.item) && use != usage.ofMaterial.end()
            && use->second.panels + use->second.threads + use->second.biases > 0)
            cloths.push_back(entry.id);
    }
    return cloths;
}

std::vector<const Preset*> clothPresets()
{
    std::vector<const Preset*> cloths;
    for (const Preset& preset : allPresets())
        if (isSheet(preset.kind))
            cloths.push_back(&preset);
    return cloths;
}

} // namespace ripstop
