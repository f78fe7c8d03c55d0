#include "outline/new_item.h"

#include "derived/collider_shape.h"
#include "document/census.h"
#include "select/group.h"

#include <algorithm>

namespace ripstop {
namespace {

std::vector<Id> idsOf(const Census& all, std::initializer_list<Kind> kinds)
{
    std::vector<Id> ids;
    for (const Kind kind : kinds)
        for (const Census::Found& found : all[kind])
            ids.push_back(found.id);
    std::sort(ids.begin(), ids.end());
    return ids;
}

Probe newProbe(const Census& all)
{
    Probe probe;
    const auto particles = idsOf(all, {Kind::Particle});
    const auto links = idsOf(all, {Kind::Link});
    const auto wholes = idsOf(all, {Kind::Part, Kind::Group});
    if (particles.size() == 2) {
        probe.quantity = Quantity::Distance;
        probe.from = particles.front();
        probe.target = particles.back();
    } else if (!particles.empty()) {
        probe.target = particles.front();
    } else if (!links.empty()) {
        probe.quantity = Quantity::Tension;
        probe.target = links.front();
    } else if (!wholes.empty()) {
        probe.target = wholes.front();
    } else {
        probe.quantity = Quantity::TotalEnergy;
    }
    return probe;
}

Item itemOf(Kind kind, const Census& all)
{
    switch (kind) {
    case Kind::Group:
        return Group{"", idsOf(all, {Kind::Particle, Kind::Link, Kind::Panel})};
    case Kind::Wind: {
        Wind wind;
        wind.velocity = Vec3(6.0, 0.0, 0.0); // m/s, a moderate breeze
        return wind;
    }
    case Kind::Control: {
        Control control;
        control.targets = idsOf(all, {Kind::Particle, Kind::Collider});
        return control;
    }
    case Kind::Probe:
        return newProbe(all);
    case Kind::Plot: {
        Plot plot;
        plot.probes = idsOf(all, {Kind::Probe});
        return plot;
    }
    default:
        return Material{};
    }
}

} // namespace

Entry newItem(const Scene& scene, Kind kind, const std::vector<Id>& selected)
{
    Entry entry{scene.nextId, itemOf(kind, census(scene, selected))};
    std::visit([&](auto& item) { item.name = freeName(scene, kindName(kind)); }, entry.item);
    return entry;
}

Entry newCollider(const Scene& scene, ColliderShape shape, const std::string& file)
{
    Collider collider;
    collider.name = freeName(scene, kindName(Kind::Collider));
    collider.shape = shape;
    collider.file = file;
    const ShapeRow& row = rowOf(shape);
    if (row.isGround)
        collider.size = Vec3(20.0, 2.0, 20.0); // m
    const bool isBody = row.madeOf == MadeOf::Numbers && !row.bounds(solidOf(collider)).isEmpty();
    if (isBody)
        collider.position.y() = 1.0; // m, beside a ground at 0 rather than half in it
    return {scene.nextId, std::move(collider)};
}

} // namespace ripstop
