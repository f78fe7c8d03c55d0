#include "compile/resolve.h"
#include "derived/canopy_shape.h"

#include <algorithm>

namespace ripstop {
namespace {

Canopy canopyOf(const CanopyPiece& piece, const Part& part, int firstPanel,
                const ElementIndex& index)
{
    Canopy canopy;
    canopy.pressureCoefficient = part.canopyPressure;
    canopy.fillEfficiency = part.fillEfficiency;
    canopy.addedMass = part.addedMass;
    for (const CanopyPiece::Facet& facet : piece.facets) {
        canopy.area += facet.area;
        for (const Id id : facet.corner)
            canopy.particles.push_back(index.particle(id));
    }
    std::sort(canopy.particles.begin(), canopy.particles.end());
    canopy.particles.erase(std::unique(canopy.particles.begin(), canopy.particles.end()),
                           canopy.particles.end());
    const auto place = [&](Id id) {
        const auto found =
            std::lower_bound(canopy.particles.begin(), canopy.particles.end(), index.particle(id));
        return int(found - canopy.particles.begin());
    };
    const auto places = [&](const std::vector<Id>& loop) {
        std::vector<int> made;
        for (const Id id : loop)
            made.push_back(place(id));
        return made;
    };
    for (const CanopyPiece::Facet& facet : piece.facets)
        canopy.facets.push_back(
            {firstPanel + facet.panel,
             {place(facet.corner[0]), place(facet.corner[1]), place(facet.corner[2])},
             facet.area / canopy.area});
    canopy.mouth = places(piece.mouth);
    for (const std::vector<Id>& vent : piece.vents)
        canopy.vents.push_back(places(vent));
    return canopy;
}

} // namespace

std::vector<Canopy> canopiesOf(const Scene& scene, const ElementIndex& index)
{
    std::vector<Canopy> canopies;
    int firstPanel = 0;
    forEachPart(scene, [&](Id id, const Part& part) {
        // What fails here was found by the check before.
        if (const auto pieces =
                part.canopyPressure > 0.0 ? canopyPieces(part) : std::vector<CanopyPiece>())
            for (std::size_t i = 0; i < pieces->size(); ++i) {
                canopies.push_back(canopyOf((*pieces)[i], part, firstPanel, index));
                canopies.back().part = Key(id);
                canopies.back().piece = int(i);
            }
        firstPanel += int(part.panels.size());
    });
    return canopies;
}

} // namespace ripstop
