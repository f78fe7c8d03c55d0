#include "scene/scene.h"

#include <algorithm>

namespace ripstop {

Id takeId(Scene& scene)
{
    const Id id = scene.nextId;
    scene.nextId = Id{std::uint32_t(id) + 1};
    return id;
}

Item* findItem(Scene& scene, Id id)
{
    for (Entry& entry : scene.items)
        if (entry.id == id)
            return &entry.item;
    return nullptr;
}

const Item* findItem(const Scene& scene, Id id) { return findItem(const_cast<Scene&>(scene), id); }

bool isPanel(const Scene& scene, Id element)
{
    return std::ranges::any_of(scene.items, [&](const Entry& entry) {
        const Part* part = std::get_if<Part>(&entry.item);
        return part && findRow(part->panels, element);
    });
}

template <typename Row>
Row* findRow(std::vector<Row>& rows, Id id)
{
    const auto row = std::lower_bound(rows.begin(), rows.end(), id,
                                      [](const Row& r, Id wanted) { return r.id < wanted; });
    return row != rows.end() && row->id == id ? &*row : nullptr;
}
template Particle* findRow(std::vector<Particle>&, Id);
template Link* findRow(std::vector<Link>&, Id);
template Panel* findRow(std::vector<Panel>&, Id);

const std::string& nameOf(const Item& item)
{
    return std::visit([](const auto& i) -> const std::string& { return i.name; }, item);
}

} // namespace ripstop
