#include "look/element_places.h"

#include "select/elements.h"

#include <algorithm>

namespace ripstop {

std::vector<Vec3> placesOf(const Frame& frame, const Scene& scene, const std::vector<Id>& ids)
{
    const std::vector<Id> elements = elementsOf(scene, ids);
    const auto isMeant = [&](std::uint32_t id) {
        return std::ranges::binary_search(elements, Id(id));
    };
    std::vector<Vec3> places;
    const auto add = [&](int particle) { places.push_back(frame.position[std::size_t(particle)]); };
    const Layout& layout = *frame.layout;
    for (std::size_t i = 0; i < layout.particleId.size(); ++i)
        if (isMeant(layout.particleId[i]))
            add(int(i));
    for (const Layout::Link& link : layout.links)
        if (isMeant(link.id))
            for (const int end : {link.a, link.b})
                add(end);
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        if (isMeant(layout.panelId[i]))
            for (const int corner : layout.panelCorners[i])
                add(corner);
    return places;
}

} // namespace ripstop
