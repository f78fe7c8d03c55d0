#include "author/pin.h"

#include "author/movable.h"

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
    Edit edit{pinned ? "Pin" : "Unpin", {}};
    std::vector<Id> particles = particlesOf(scene, ids);
    if (!particles.empty())
        edit.changes.emplace_back(
            SetValues{findProperty(Kind::Particle, "pinned"), std::move(particles), {pinned}});
    return edit;
}

} // namespace ripstop
