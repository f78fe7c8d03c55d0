#include "derived/material_of.h"

namespace ripstop {

const Material& materialOf(const Scene& scene, const ElementIndex& index, Id id)
{
    static const Material none;
    const int place = index.material(id);
    return place < 0 ? none : std::get<Material>(scene.items[std::size_t(place)].item);
}

} // namespace ripstop
