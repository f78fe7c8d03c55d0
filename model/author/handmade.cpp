// Rows are compared in their order, where the tables are as long: copying keeps it.
#include "author/handmade.h"

#include "author/rebuild.h"
#include "author/tuned_weights.h"
#include "scene/property.h"
#include "shaping/brush.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

// Masses add up in another order when a material has been exchanged more than once.
bool isSame(const Property& property, const Value& built, const Value& held)
{
    if (!isOneOf<&Particle::mass>(property))
        return built == held;
    const double mass = std::get<double>(built);
    return std::abs(std::get<double>(held) - mass) <= 1e-9 * std::abs(mass);
}

template <typename Row>
void countDifferent(HandmadeParts& work, const Row& built, const Row& held,
                    const std::map<Id, Id>& heldAs)
{
    bool isChanged = false;
    bool isPainted = false;
    for (const Property& property : propertiesOf(kindOf(ConstRef(&built)))) {
        if (isOneOf<&Particle::position, &Particle::velocity>(property))
            continue;
        Value wanted = property.get(&built);
        if (Id* id = std::get_if<Id>(&wanted))
            if (const auto found = heldAs.find(*id); found != heldAs.end())
                *id = found->second;
        if (!isSame(property, wanted, property.get(&held)))
            (isPaint(property) ? isPainted : isChanged) = true;
    }
    work.changed += isChanged;
    work.painted += isPainted;
}

} // namespace

HandmadeParts handWork(const Part& built, const Part& held, const Counterparts& counterparts)
{
    HandmadeParts work;
    const auto count = [&](const auto& made, const auto& there) {
        work.added += there.size() - std::min(made.size(), there.size());
        work.removed += made.size() - std::min(made.size(), there.size());
        if (made.size() == there.size())
            for (std::size_t i = 0; i < made.size(); ++i)
                countDifferent(work, made[i], there[i], counterparts.heldAs);
    };
    count(built.particles, held.particles);
    count(built.links, held.links);
    count(built.panels, held.panels);
    if (built.particles.size() == held.particles.size())
        for (std::size_t i = 0; i < built.particles.size(); ++i) {
            const Vec3 place = counterparts.motion.map * built.particles[i].position;
            if ((held.particles[i].position - place).norm() > counterparts.tolerance)
                ++work.moved;
        }
    return work;
}

HandmadeParts handWork(const Scene& scene, Id id)
{
    const Part& part = *findItem<Part>(scene, id);
    Result<Scene> before = build(*builderOf(part), part.parameters);
    if (!before)
        return {};
    const Counterparts counterparts = counterpartsOf(scene, id, *before);
    weighAsTuned(scene, counterparts, *before, *before);
    return handWork(std::get<Part>(partEntry(*before).item), part, counterparts);
}

} // namespace ripstop
