#include "author/tuned_weights.h"

#include "scene/property.h"
#include "scene/weigh.h"

namespace ripstop {
namespace {

// The material of the scene that stands for one that was built, or null.
const Material* heldMaterial(const Scene& scene, const Counterparts& counterparts, Id built)
{
    const auto found = counterparts.heldAs.find(built);
    return found == counterparts.heldAs.end() ? nullptr : findItem<Material>(scene, found->second);
}

const Entry* materialNamed(const Scene& scene, const std::string& name)
{
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item);
            material && material->name == name)
            return &entry;
    return nullptr;
}

// Where a particle would be left without mass, all stay as they were built.
void weighAnew(Scene& scene, const Edit& densities)
{
    if (densities.changes.empty())
        return;
    if (const Result<Edit> edit = weighed(scene, densities))
        (void)apply(scene, *edit);
}

// Calls visit(material as built, its name, density, value in the scene) for each that differs.
template <typename Visit>
void forEachTuned(const Scene& scene, const Counterparts& counterparts, const Scene& built,
                  Visit visit)
{
    for (const Entry& entry : built.items) {
        const auto* material = std::get_if<Material>(&entry.item);
        const Material* held = material ? heldMaterial(scene, counterparts, entry.id) : nullptr;
        if (!held)
            continue;
        for (const Property& property : propertiesOf(Kind::Material))
            if (weighs(property) && property.get(held) != property.get(material))
                visit(entry, *material, property, property.get(held));
    }
}

} // namespace

void weighAsTuned(const Scene& scene, const Counterparts& counterparts, Scene& before, Scene& after)
{
    Edit then, now;
    forEachTuned(
        scene, counterparts, before,
        [&](const Entry& entry, const Material& material, const Property& property,
            const Value& value) {
            then.changes.emplace_back(SetValues{&property, {entry.id}, {value}});
            const Entry* same = materialNamed(after, material.name);
            if (same && property.get(&std::get<Material>(same->item)) == property.get(&material))
                now.changes.emplace_back(SetValues{&property, {same->id}, {value}});
        });
    weighAnew(before, then);
    weighAnew(after, now);
}

void weighAsTuned(const Scene& scene, const Counterparts& counterparts, Scene& built)
{
    Scene none;
    weighAsTuned(scene, counterparts, built, none);
}

} // namespace ripstop
