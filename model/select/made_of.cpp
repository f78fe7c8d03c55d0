#include "select/made_of.h"

#include "select/elements.h"

#include <set>

namespace ripstop {

std::vector<Id> materialsOf(const Scene& scene, const std::vector<Id>& selected)
{
    std::set<Id> wanted;
    std::vector<Id> others;
    for (const Id id : selected)
        if (findItem<Material>(scene, id))
            wanted.insert(id);
        else
            others.push_back(id);
    const Elements elements = sortedElements(scene, others);
    for (const Link* link : elements.links)
        wanted.insert(link->material);
    for (const Panel* panel : elements.panels)
        wanted.insert(panel->material);

    std::vector<Id> materials;
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Material>(entry.item) && wanted.contains(entry.id))
            materials.push_back(entry.id);
    return materials;
}

} // namespace ripstop
