#include "check/start_check.h"

#include "derived/collider_start.h"
#include "laws/guide.h"

#include <cstddef>

namespace ripstop {
namespace {

// Those of one part that begin inside one collider.
struct Inside
{
    std::size_t count = 0;
    double depth = 0.0; // m, of the deepest
    Id deepest = noId;
};

// Contact moves what is free at all and what a guide lets go along the normal.
bool givesWay(const Particle& particle, const Vec3& normal)
{
    const GuidedParticle guided{-1, particle.guide, particle.guideAxis.normalized()};
    return !particle.pinned && !guided.freePart(normal).isZero(1e-9);
}

Inside insideOf(const ColliderStart& collider, const Part& part)
{
    Inside inside;
    for (const Particle& particle : part.particles) {
        const auto touch = collider.wayOut(particle.position);
        if (!touch || !givesWay(particle, touch->normal))
            continue;
        ++inside.count;
        const double depth = (touch->surface - particle.position).norm();
        if (depth > inside.depth) {
            inside.depth = depth;
            inside.deepest = particle.id;
        }
    }
    return inside;
}

Message sentence(const Inside& inside, const Part& part, const Collider& collider)
{
    const Message depth = Message::number("%.3g", inside.depth);
    const Message told =
        inside.count == 1
            ? Message("1 particle of %1 begins inside %2, by %3 m: contact puts it outside in the "
                      "first step, which stretches what it is tied to and makes energy out of "
                      "nothing. Move %1 or %2.",
                      part.name, collider.name, depth)
            : Message("%1 particles of %2 begin inside %3, by up to %4 m: contact puts them "
                      "outside in the first step, which stretches what they are tied to and makes "
                      "energy out of nothing. Move %2 or %3.",
                      inside.count, part.name, collider.name, depth);
    return collider.thickness > 0.0
               ? Message("%1 The thickness of %2, %3 m, counts.", told, collider.name,
                         Message::number("%.3g", collider.thickness))
               : told;
}

} // namespace

void checkStart(const Scene& scene, const AddFinding& add)
{
    for (const Entry& entry : scene.items) {
        const Collider* const collider = std::get_if<Collider>(&entry.item);
        if (!collider)
            continue;
        const ColliderStart start(scene, *collider);
        forEachPart(scene, [&](Id, const Part& part) {
            if (const Inside inside = insideOf(start, part); inside.count > 0)
                add("inside", Severity::Warning, sentence(inside, part, *collider), inside.deepest);
        });
    }
}

} // namespace ripstop
