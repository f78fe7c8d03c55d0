// Grains that differ end the search at once, so that fabric as it should be costs nothing.
#include "derived/scattered_warps.h"

#include "derived/flat_panel.h"
#include "scene/particle_of.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

constexpr double noticed = 5.0; // degrees

bool hasDirection(const Material& material)
{
    return material.membraneStiffness
           && (material.shearStiffness
               || material.weftStiffness.value_or(*material.membraneStiffness)
                      != *material.membraneStiffness);
}

// Calls visit(panel, a, b, c) for each panel whose corners are there.
template <typename Visit>
void forEachCut(const Scene& scene, const Part& part, Visit visit)
{
    for (const Panel& panel : part.panels) {
        const Particle* const a = particleOf(scene, panel.a);
        const Particle* const b = particleOf(scene, panel.b);
        const Particle* const c = particleOf(scene, panel.c);
        if (a && b && c)
            visit(panel, *a, *b, *c);
    }
}

// Degrees, of the two that lie farthest apart; 0 without any. Angles are those of ways that run
// both ways, so that the widest gap around the half circle is what is left out.
double widest(std::vector<double> turns)
{
    if (turns.empty())
        return 0.0;
    std::ranges::sort(turns);
    double gap = 180.0 - (turns.back() - turns.front());
    for (std::size_t i = 1; i < turns.size(); ++i)
        gap = std::max(gap, turns[i] - turns[i - 1]);
    return std::min(180.0 - gap, 90.0);
}

} // namespace

std::vector<ScatteredWarps> scatteredWarps(const Scene& scene)
{
    std::vector<ScatteredWarps> scattered;
    forEachPart(scene, [&](Id id, const Part& part) {
        if (part.carrier != FabricKind::Panels || part.panels.size() < 2)
            return;
        const Panel& first = part.panels.front();
        const bool isOne = std::ranges::all_of(
            part.panels, [&](const Panel& panel) { return panel.grain == first.grain; });
        const auto* const material = findItem<Material>(scene, first.material);
        if (!isOne || !material || !hasDirection(*material))
            return;
        std::vector<double> turns;
        forEachCut(scene, part,
                   [&](const Panel& panel, const Particle& a, const Particle& b,
                       const Particle& c) { turns.push_back(grainTurn(panel, a, b, c)); });
        if (const double apart = widest(std::move(turns)); apart > noticed)
            scattered.push_back({id, first.grain, apart});
    });
    return scattered;
}

Edit turnedOneWay(const Scene& scene, const std::vector<ScatteredWarps>& parts)
{
    SetValues grains{&propertyOf<&Panel::grain>(), {}, {}};
    for (const ScatteredWarps& scattered : parts)
        if (const Part* part = findItem<Part>(scene, scattered.part))
            forEachCut(
                scene, *part,
                [&](const Panel& panel, const Particle& a, const Particle& b, const Particle& c) {
                    grains.targets.push_back(panel.id);
                    grains.values.emplace_back(turnedGrain(uprightGrain(a, b, c), scattered.grain));
                });
    return {Message("Turn warps one way"), {std::move(grains)}};
}

} // namespace ripstop
