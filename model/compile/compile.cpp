// A compile checks the scene, then fills the system in the order of its arrays: settings,
// particles, links, panels, winds and other items, and last what is derived of all. The order of
// the rods is found before they are made, so that each is written once.
#include "compile/compile.h"

#include "assembly/finish.h"
#include "base/key_index.h"
#include "check/check.h"
#include "check/step_limits.h"
#include "compile/resolve.h"
#include "constraints/rod_order.h"
#include "derived/flat_panel.h"
#include "derived/material_of.h"

#include <algorithm>
#include <span>

namespace ripstop {
namespace {

void reserve(const Scene& scene, System& system)
{
    std::size_t particles = 0;
    std::size_t links = 0;
    std::size_t panels = 0;
    forEachPart(scene, [&](Id, const Part& part) {
        particles += part.particles.size();
        links += part.links.size();
        panels += part.panels.size();
    });
    system.key.reserve(particles);
    system.mass.reserve(particles);
    system.inverseMass.reserve(particles);
    system.start.position.reserve(particles);
    system.start.velocity.reserve(particles);
    system.links.reserve(links);
    system.linkStuff.reserve(links);
    system.panels.reserve(panels);
    system.panelKey.reserve(panels);
}

void addParticles(const Part& part, System& system)
{
    for (const Particle& row : part.particles) {
        const int place = int(system.key.size());
        if (const GuidedParticle guided = guidedOf(row, place); guided.guide != Guide::None)
            system.guided.push_back(guided);
        takeParticle(row, place, system);
    }
}

void addLinkFactors(const Scene& scene, System& system)
{
    const auto isOther = [](const Link& row) { return factorsOf(row) != LinkFactors(); };
    bool any = false;
    forEachPart(scene,
                [&](Id, const Part& part) { any |= std::ranges::any_of(part.links, isOther); });
    if (any)
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& row : part.links)
                system.linkFactors.push_back(factorsOf(row));
        });
}

// Puts links and what they became into the system; the order of the rods is found before they are
// made, so that each is written once.
RodOrder addLinks(const Scene& scene, const ElementIndex& index, System& system)
{
    std::vector<const Link*> springs;
    std::vector<const Link*> rods;
    std::vector<RodEnds> ends;
    const auto isStiff = [&](const Link& row) {
        return springNumbers(row, materialOf(scene, index, row.material)).stiffness > 0.0;
    };
    const bool together = springsAreTogether(scene, index);
    rods.reserve(system.links.capacity());
    ends.reserve(system.links.capacity());
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& row : part.links) {
            const int a = index.particle(row.from);
            const int b = index.particle(row.to);
            const bool spring = row.kind == LinkKind::Spring && !(together && isStiff(row));
            auto& rows = spring ? springs : rods;
            const LinkKind kind = spring ? LinkKind::Spring : LinkKind::Rod;
            system.links.push_back({Key(row.id), kind, int(rows.size()), a, b});
            system.springsAsRods += std::size_t(kind != row.kind);
            system.linkStuff.push_back(stuffOf(row));
            rows.push_back(&row);
            if (!spring)
                ends.push_back({a, b});
        }
    });

    addLinkFactors(scene, system);
    system.springs.reserve(springs.size());
    for (const LinkPlace& link : system.links)
        if (link.kind == LinkKind::Spring) {
            const Link& row = *springs[std::size_t(link.index)];
            system.springs.push_back(
                springOf(row, materialOf(scene, index, row.material), link.a, link.b));
        }

    RodOrder order = orderRods(system.key.size(), std::span<const RodEnds>(ends));
    std::vector<int> place(rods.size());
    system.rods.reserve(rods.size());
    for (const int rod : order.rod) {
        const Link& row = *rods[std::size_t(rod)];
        const RodEnds& end = ends[std::size_t(rod)];
        place[std::size_t(rod)] = int(system.rods.size());
        system.rods.push_back(rodOf(row, materialOf(scene, index, row.material), end.a, end.b));
    }
    for (LinkPlace& link : system.links)
        if (link.kind == LinkKind::Rod)
            link.index = place[std::size_t(link.index)];
    return order;
}

// Of the last panel; the check before has found those that have no area.
void addMembrane(const Panel& row, System& system)
{
    const auto at = [&](int corner) -> Vec3 { return system.start.position[std::size_t(corner)]; };
    const auto& [a, b, c] = system.panels.back().corner;
    const std::optional<FlatPanel> flat = flatPanel(row, at(a), at(b), at(c));
    if (!flat)
        return;
    const double area = flat->area();
    const double scale = 0.5 / area;
    const PanelCut cut{
        area,
        {flat->ac.y() * scale, -flat->ac.x() * scale, -flat->ab.y() * scale, flat->ab.x() * scale}};
    system.membranes.push_back({cut, int(system.panels.size()) - 1, factorsOf(row)});
}

void addPanels(const Scene& scene, const ElementIndex& index, System& system)
{
    system.materialAir = materialAirOf(scene);
    system.bending = bendingsOf(scene);
    system.strength = strengthsOf(scene);
    system.cloth = clothsOf(scene);
    if (!system.cloth.empty())
        system.clothTear = fabricTearsOf(scene);
    KeyIndex airs(system.materialAir.size());
    for (const MaterialAir& air : system.materialAir)
        airs.add(air.key, int(&air - system.materialAir.data()));
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Panel& row : part.panels) {
            system.panels.push_back(
                {{index.particle(row.a), index.particle(row.b), index.particle(row.c)},
                 airs(Key(row.material))});
            system.panelKey.push_back(Key(row.id));
            if (part.carrier == FabricKind::Panels && !system.cloth.empty())
                addMembrane(row, system);
        }
    });
}

} // namespace

void compileSound(const Scene& scene, const ElementIndex& index, System& system)
{
    takeSettings(scene.settings, system);
    reserve(scene, system);
    forEachPart(scene, [&](Id id, const Part& part) {
        system.parts.push_back({Key(id), int(system.key.size())});
        addParticles(part, system);
    });
    RodOrder order = addLinks(scene, index, system);
    addPanels(scene, index, system);
    takeWinds(windsOf(scene), system);
    system.obstacles = obstaclesOf(scene);
    system.fabricLayer = fabricLayersOf(scene);
    system.canopies = canopiesOf(scene, index);
    system.inputs = inputsOf(scene, index);
    system.probes = probesOf(scene, index);
    finishOrdered(system, std::move(order));
    system.shiftedRods = shiftedRodsOf(system);
}

Result<std::shared_ptr<const System>> compile(const Scene& scene, std::uint64_t generation,
                                              std::uint64_t run)
{
    const ElementIndex index(scene);
    if (const std::optional<Finding> error = firstError(scene, index))
        return Failure(error->message);
    auto system = std::make_shared<System>();
    system->generation = generation;
    system->run = run;
    compileSound(scene, index, *system);
    return std::shared_ptr<const System>(std::move(system));
}

} // namespace ripstop
