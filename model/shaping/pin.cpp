#include "shaping/pin.h"

#include "scene/property.h"
#include "shaping/movable.h"

namespace ripstop {

bool allPinned(const Scene& scene, const std::vector<Id>& ids)
{
    const std::vector<Id> particles = particlesOf(scene, ids);
    for (const Id id : particles)
        if (!std::get<const Particle*>(*find(scene, id))->pinned)
            return false;
    return !particles.empty();
}

Edit pinning(const Scene& scene, const std::vector<Id>& ids, bool pinned)
{
    Edit edit{pinned ? Message("Pin") : Message("Unpin"), {}};
    std::vector<Id> particles = particlesOf(scene, ids);
    if (!particles.empty())
        edit.changes.emplace_back(
            SetValues{&propertyOf<&Particle::pinned>(), std::move(particles), {pinned}});
    return edit;
}

Edit guiding(const Scene& scene, const std::vector<Id>& ids, Guide guide, const Vec3& axis)
{
    const std::vector<Id> particles = particlesOf(scene, ids);
    Edit edit{guide == Guide::None ? Message("Let go") : Message("Guide"), {}};
    const auto set = [&](const Property& property, const Value& value) {
        edit.changes.emplace_back(SetValues{&property, particles, {value}});
    };
    if (particles.empty())
        return edit;
    set(propertyOf<&Particle::pinned>(), false);
    set(propertyOf<&Particle::guide>(), std::string(choiceNames<Guide>[std::size_t(guide)]));
    if (guide != Guide::None)
        set(propertyOf<&Particle::guideAxis>(), axis);
    return edit;
}

Result<Vec3> axisThrough(const Scene& scene, const std::vector<Id>& ids, Guide guide)
{
    const Movable movable = movableOf(scene, ids, Ties::Left);
    const Eigen::Vector3d spread = spreadOf(movable);
    const bool isLine = guide == Guide::Line;
    if (isLine && !(spread[0] > 0.0))
        return Failure{"A line through what is selected needs two particles in different places. "
                       "Select one more, or choose x, y or z."};
    if (!isLine && !(spread[1] > 1e-6 * spread[0]))
        return Failure{"A plane through what is selected needs three particles that are not in one "
                       "line. Select one more, or choose x, y or z."};
    return Vec3(ownAxes(movable).col(isLine ? 0 : 2));
}

} // namespace ripstop
