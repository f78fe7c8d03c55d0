// The part is built once more as it was, so that each of the builder's materials has a counterpart
// in the scene; both are known by their numbers.
#include "author/chosen_materials.h"

#include "author/counterparts.h"
#include "author/rebuild.h" // builderOf()
#include "materials/presets.h"

#include <algorithm>

namespace ripstop {
namespace {

// The one preset that all materials of the built scene with this name have become, or null.
const Preset* presentOf(std::string_view name, const Scene& built, const Scene& scene,
                        const Counterparts& counterparts)
{
    const Preset* present = nullptr;
    for (const Entry& entry : built.items) {
        const auto* made = std::get_if<Material>(&entry.item);
        const auto held = counterparts.heldAs.find(entry.id);
        if (!made || held == counterparts.heldAs.end())
            continue;
        const Preset* chosen = presetOf(*made);
        if (!chosen || chosen->name != name)
            continue;
        const auto* material = findItem<Material>(scene, held->second);
        const Preset* now = material ? presetOf(*material) : nullptr;
        if (!now || (present && present != now))
            return nullptr;
        present = now;
    }
    return present;
}

} // namespace

ChosenNow chosenNow(const Scene& scene, Id part)
{
    const Part& held = *findItem<Part>(scene, part);
    const Builder& builder = *builderOf(held);
    ChosenNow now{unsaid(builder), {}}; // a file may be older than a parameter
    for (const auto& [key, value] : held.parameters)
        now.parameters[key] = value;
    const Result<Scene> built = build(builder, held.parameters);
    if (!built)
        return now;
    const Counterparts counterparts = counterpartsOf(scene, part, *built);
    for (const Parameter& parameter : builder.parameters) {
        double& choice = now.parameters[std::string(parameter.key)];
        if (!(choice >= 0.0 && choice < double(parameter.choices.size())))
            continue;
        const std::string_view chosen = parameter.choices[std::size_t(choice)];
        const Preset* present = presentOf(chosen, *built, scene, counterparts);
        if (!present || present->name == chosen)
            continue;
        const auto offered = std::ranges::find(parameter.choices, present->name);
        if (offered != parameter.choices.end())
            choice = double(offered - parameter.choices.begin());
        else
            now.others.push_back({parameter.key, present});
    }
    return now;
}

} // namespace ripstop
