// Corners are sorted once, so that a part costs little more than its rows.
#include "shaping/fabric_places.h"

#include <algorithm>

namespace ripstop {

std::vector<Vec3> fabricPlacesOf(const Part& part)
{
    std::vector<Id> joined;
    for (const Panel& row : part.panels)
        joined.insert(joined.end(), {row.a, row.b, row.c});
    std::ranges::sort(joined);
    std::vector<Vec3> places;
    for (const Particle& row : part.particles)
        if (!row.position.hasNaN()
            && (joined.empty() || std::ranges::binary_search(joined, row.id)))
            places.push_back(row.position);
    return places;
}

} // namespace ripstop
