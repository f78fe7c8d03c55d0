#include "author/tuned_weights.h"

#include "scene/path.h"
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

} // namespace

void weighAsTuned(const Scene& scene, const Counterparts& counterparts, const Scene& before,
                  Scene& built)
{
    Edit densities;
    for (const Entry& entry : before.items) {
        const auto* made = std::get_if<Material>(&entry.item);
        const Material* held = made ? heldMaterial(scene, counterparts, entry.id) : nullptr;
        const auto same = held ? findNamed(built, Kind::Material, made->name) : noId;
        const Material* now = same && *same != noId ? findItem<Material>(built, *same) : nullptr;
        if (!now)
            continue;
        for (const Property& property : propertiesOf(Kind::Material)) {
            const Value tuned = property.get(held);
            const bool isBuilders = property.get(made) != property.get(now);
            if (weighs(property) && !isBuilders && tuned != property.get(now))
                densities.changes.emplace_back(SetValues{&property, {*same}, {tuned}});
        }
    }
    // where a particle would be left without mass, all stay as they were built
    if (const Result<Edit> edit = weighed(built, std::move(densities)))
        (void)apply(built, *edit);
}

} // namespace ripstop
