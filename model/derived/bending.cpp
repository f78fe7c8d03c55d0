#include "derived/bending.h"

#include "derived/material_of.h"
#include "laws/fabric_bending.h"

#include <algorithm>

namespace ripstop {
namespace {

bool isLimp(const Scene& scene)
{
    return std::none_of(scene.items.begin(), scene.items.end(), [](const Entry& entry) {
        const Material* material = std::get_if<Material>(&entry.item);
        return material && (material->bendingStiffness > 0.0 || material->flexuralRigidity > 0.0);
    });
}

Bending bendingOf(const Scene& scene, const ElementIndex& index, Id id)
{
    const Material& m = materialOf(scene, index, id);
    return {m.bendingStiffness, m.flexuralRigidity};
}

} // namespace

std::vector<double> bendSumsOf(const Scene& scene, const ElementIndex& index,
                               const std::function<bool(const Link&)>& isRod)
{
    if (isLimp(scene))
        return {};
    BendingNet net;
    std::vector<double> mass;
    std::vector<std::uint8_t> carries; // [panels of the net] a pull
    net.solvesTogether = solvesTogether(scene.settings.solver);
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& row : part.particles) {
            net.position.push_back(row.position);
            net.pinned.push_back(row.pinned);
            mass.push_back(row.pinned ? 0.0 : row.mass);
        }
        for (const Panel& row : part.panels) {
            const std::array corner{index.particle(row.a), index.particle(row.b),
                                    index.particle(row.c)};
            if (std::min({corner[0], corner[1], corner[2]}) >= 0)
                net.panels.push_back({corner, bendingOf(scene, index, row.material)});
            carries.resize(net.panels.size(), part.carrier == FabricKind::Panels);
        }
        for (const Link& row : part.links) {
            const int a = index.particle(row.from);
            const int b = index.particle(row.to);
            if (a >= 0 && b >= 0 && a != b)
                net.links.push_back({a, b, row.restLength, std::uint32_t(row.material),
                                     bendingOf(scene, index, row.material), isRod(row)});
        }
    });
    const BendsAndPanels found = bendsAndPanelsOf(net);
    std::span forces = std::span(found.bends).first(countOfForces(found.bends));
    if (scene.settings.solver == Solver::Auto
        && isSolvedWithPull(found, carries, mass, scene.settings.timeStep))
        forces = forces.subspan(countOfFabric(found.bends));
    return bendSums(forces, net.position.size());
}

} // namespace ripstop
