#include "author/targets.h"

#include "derived/cloth_area.h"
#include "select/elements.h"
#include "shaping/spread_mass.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ripstop {
namespace {

constexpr double near = 0.005; // 1, of the target

double massOf(const Elements& elements)
{
    double mass = 0.0;
    for (const Particle* row : elements.particles)
        mass += row->mass;
    return mass;
}

double lengthOf(const Elements& elements)
{
    double length = 0.0;
    for (const Link* row : elements.links)
        length += row->role == LinkRole::Line ? row->restLength : 0.0;
    return length;
}

double areaOf(const Scene& scene, const Elements& elements)
{
    double area = 0.0;
    forEachPart(scene, [&](Id, const Part& part) {
        const ClothArea cloth(part, &scene);
        for (const Panel* row : elements.panels)
            if (findRow(part.panels, row->id) == row)
                area += cloth.of(*row);
    });
    return area;
}

template <typename Holder>
std::vector<Target> targetsOf(const Scene& scene, const Holder& holder, Id id)
{
    std::vector<Target> targets;
    if (!holder.massTarget && !holder.lengthTarget && !holder.areaTarget)
        return targets;
    const Elements elements = sortedElements(scene, elementsOf(scene, {id}));
    const auto add = [&](TargetOf of, const Property& property, const std::optional<double>& wanted,
                         auto value) {
        if (wanted)
            targets.push_back({&property, value(), *wanted, of});
    };
    add(TargetOf::Mass, propertyOf<&Holder::massTarget>(), holder.massTarget,
        [&] { return massOf(elements); });
    add(TargetOf::Length, propertyOf<&Holder::lengthTarget>(), holder.lengthTarget,
        [&] { return lengthOf(elements); });
    add(TargetOf::Area, propertyOf<&Holder::areaTarget>(), holder.areaTarget,
        [&] { return areaOf(scene, elements); });
    return targets;
}

} // namespace

bool Target::isMet() const { return std::abs(excess()) <= near * wanted; }

std::vector<Target> targetsOf(const Scene& scene, Id id)
{
    if (const Part* part = findItem<Part>(scene, id))
        return targetsOf(scene, *part, id);
    if (const Group* group = findItem<Group>(scene, id))
        return targetsOf(scene, *group, id);
    return {};
}

Result<Edit> massBroughtToTarget(const Scene& scene, Id id)
{
    for (const Target& target : targetsOf(scene, id)) {
        if (target.of != TargetOf::Mass)
            continue;
        const Elements elements = sortedElements(scene, elementsOf(scene, {id}));
        std::vector<Id> particles;
        for (const Particle* row : elements.particles)
            particles.push_back(row->id);
        Result<Edit> edit = massSpread(scene, particles, MassBy::TotalInProportion, target.wanted);
        if (edit)
            edit->label = Message("Bring mass to target");
        return edit;
    }
    return Failure{"No target mass is set."};
}

} // namespace ripstop
