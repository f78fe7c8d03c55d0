// A stroke notes each element that can be painted with its middle, its number before and that of
// the brush; paint() raises weights and edit() says what comes of them. Ways are straight pieces,
// so that the distance to one is exact however far the hand went between two events.
#include "shaping/brush.h"

#include "derived/flat_panel.h"
#include "scene/particle_of.h"
#include "select/elements.h"
#include "shaping/fabric_places.h"
#include "shaping/mirror_plane.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

double distanceToWay(const Vec3& place, const Vec3& from, const Vec3& to) // m
{
    const Vec3 way = to - from;
    const double square = way.squaredNorm();
    const double share =
        square > 0.0 ? std::clamp((place - from).dot(way) / square, 0.0, 1.0) : 0.0;
    return (place - from - share * way).norm();
}

} // namespace

void Brush::widen(double factor)
{
    const double wanted = std::clamp(radius * factor, narrowest, widest);
    const double unit = std::pow(10.0, std::floor(std::log10(wanted)) - 2.0);
    radius = std::clamp(std::round(wanted / unit) * unit, narrowest, widest);
}

double Brush::weightAt(double distance) const
{
    if (distance > radius)
        return 0.0;
    if (falloff == Falloff::Hard)
        return 1.0;
    const double square = distance * distance / (radius * radius);
    return (1.0 - square) * (1.0 - square);
}

double fittingRadius(const Scene& scene)
{
    Eigen::AlignedBox3d box;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Vec3& place : fabricPlacesOf(part))
            box.extend(place);
    });
    const double share = box.isEmpty() ? 0.0 : 0.05 * box.diagonal().norm();
    if (!(share > 0.0))
        return Brush().radius;
    const double unit = std::pow(10.0, std::floor(std::log10(share)));
    return std::max(std::round(share / unit), 1.0) * unit;
}

const Property* paintedProperty(Painted what, Kind kind)
{
    const bool ofLinks = kind == Kind::Link;
    switch (what) {
    case Painted::Strength:
        return ofLinks ? &propertyOf<&Link::strengthFactor>()
                       : &propertyOf<&Panel::strengthFactor>();
    case Painted::Stiffness:
        return ofLinks ? &propertyOf<&Link::stiffnessFactor>()
                       : &propertyOf<&Panel::stiffnessFactor>();
    case Painted::Grain:
        return ofLinks ? nullptr : &propertyOf<&Panel::grain>();
    }
    return nullptr;
}

bool isPaint(const Property& property)
{
    return isOneOf<&Link::strengthFactor, &Link::stiffnessFactor, &Panel::strengthFactor,
                   &Panel::stiffnessFactor, &Panel::grain>(property);
}

BrushStroke::BrushStroke(const Scene& scene, const Brush& brush)
    : m_brush(brush)
{
    forEachPart(scene, [&](Id, const Part& part) { add(scene, part); });
}

void BrushStroke::add(const Scene& scene, const Part& part)
{
    const bool byPanels = part.carrier == FabricKind::Panels;
    const Property* property = paintedProperty(m_brush.what, byPanels ? Kind::Panel : Kind::Link);
    if (!property)
        return;
    const auto number = [&](const auto& row) { return std::get<double>(property->get(&row)); };
    const MirrorPlane plane = m_brush.mirrors ? mirrorPlaneOf(part) : MirrorPlane();
    if (byPanels) {
        for (const Panel& row : part.panels) {
            const Particle* const a = particleOf(scene, row.a);
            const Particle* const b = particleOf(scene, row.b);
            const Particle* const c = particleOf(scene, row.c);
            if (!a || !b || !c)
                continue;
            const double upright = m_brush.what == Painted::Grain ? uprightGrain(*a, *b, *c) : 0.0;
            const Vec3 middle = (a->position + b->position + c->position) / 3.0;
            m_spots.push_back(
                {middle, plane.mirrored(middle), row.id, Kind::Panel, number(row), upright});
        }
        return;
    }
    std::vector<Id> covered; // corners of panels
    for (const Panel& row : part.panels)
        covered.insert(covered.end(), {row.a, row.b, row.c});
    std::ranges::sort(covered);
    const auto isOutside = [&](Id end) {
        return !covered.empty() && !std::ranges::binary_search(covered, end);
    };
    for (const Link& row : part.links) {
        const Particle* const from = particleOf(scene, row.from);
        const Particle* const to = particleOf(scene, row.to);
        if (!from || !to || isOutside(row.from) || isOutside(row.to))
            continue;
        const Vec3 middle = 0.5 * (from->position + to->position);
        m_spots.push_back({middle, plane.mirrored(middle), row.id, Kind::Link, number(row), 0.0});
    }
}

bool BrushStroke::paint(const Vec3& from, const Vec3& to)
{
    bool changes = false;
    for (Spot& spot : m_spots) {
        const double before = valueOf(spot);
        const auto touch = [&](const Vec3& place, bool isImage) {
            const double distance = distanceToWay(place, from, to);
            if (distance < spot.nearest)
                spot.isImage = isImage;
            spot.nearest = std::min(spot.nearest, distance);
        };
        touch(spot.place, false);
        if (m_brush.mirrors)
            touch(spot.image, true);
        changes |= valueOf(spot) != before;
    }
    return changes;
}

std::size_t BrushStroke::count() const
{
    return std::size_t(
        std::ranges::count_if(m_spots, [this](const Spot& spot) { return weightOf(spot) > 0.0; }));
}

double BrushStroke::valueOf(const Spot& spot) const
{
    const double weight = weightOf(spot);
    if (weight == 0.0)
        return spot.from;
    const bool turns = m_brush.what == Painted::Grain;
    const double value = m_brush.value();
    const double to = turns ? turnedGrain(spot.upright, spot.isImage ? -value : value) : value;
    if (weight == 1.0)
        return to;
    return turns ? turnedGrain(spot.from, weight * std::remainder(to - spot.from, 180.0))
                 : spot.from + weight * (to - spot.from);
}

Edit BrushStroke::edit() const
{
    Edit edit;
    for (const Kind kind : {Kind::Link, Kind::Panel}) {
        SetValues values{paintedProperty(m_brush.what, kind), {}, {}};
        for (const Spot& spot : m_spots)
            if (spot.kind == kind && weightOf(spot) > 0.0) {
                values.targets.push_back(spot.id);
                values.values.emplace_back(valueOf(spot));
            }
        if (values.targets.empty())
            continue;
        edit.label = Message("Paint %1", Message::word(values.property->label));
        edit.changes.emplace_back(std::move(values));
    }
    return edit;
}

} // namespace ripstop
