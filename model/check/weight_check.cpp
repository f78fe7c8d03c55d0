// One pass over all links adds up what each particle hangs from; a look at each particle follows.
#include "check/weight_check.h"

#include "derived/collider_shape.h"
#include "derived/tear_bounds.h"

#include <algorithm>
#include <vector>

namespace ripstop {
namespace {

constexpr double slack = 0.95;  // of its rest length: a link that is shorter does not hold yet
constexpr double resting = 0.1; // m, above a collider; what is nearer may come to lie on it

// What holds one particle.
struct Hold
{
    double strength = 0.0; // N, of all its links
    int links = 0;
    bool isTaut = false;      // one of them is
    bool isUnlimited = false; // something holds it that no weight breaks
};

bool isFree(const Particle& particle)
{
    return !particle.pinned && particle.guide == Guide::None && particle.mass > 0.0;
}

// Whether something can hold a weight up: a particle that stays, or fabric in the air.
bool hasSupport(const Scene& scene)
{
    return std::ranges::any_of(scene.items, [](const Entry& entry) {
        const Part* const part = std::get_if<Part>(&entry.item);
        return part
               && (!part->panels.empty()
                   || std::ranges::any_of(part->particles, [](const Particle& particle) {
                          return particle.pinned || particle.guide != Guide::None;
                      }));
    });
}

bool liesOnCollider(const Scene& scene, const Vec3& place)
{
    return std::ranges::any_of(scene.items, [&](const Entry& entry) {
        const Collider* const collider = std::get_if<Collider>(&entry.item);
        return collider && mayLieOn(scene, *collider, place, resting);
    });
}

class Weights
{
public:
    Weights(const Scene& scene, const ElementIndex& index)
        : m_scene(scene)
        , m_index(index)
        , m_up(-scene.settings.gravity.normalized())
    {
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Particle& particle : part.particles)
                m_particles.push_back(&particle);
        });
        m_holds.resize(m_particles.size());
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Link& link : part.links)
                takeLink(link);
            for (const Panel& panel : part.panels)
                for (const Id corner : {panel.a, panel.b, panel.c})
                    holdForGood(corner);
        });
        for (const Entry& entry : scene.items)
            if (const Control* control = std::get_if<Control>(&entry.item))
                for (const Id target : control->targets)
                    holdForGood(target);
    }

    void tell(const AddFinding& add) const
    {
        const double gravity = m_scene.settings.gravity.norm();
        forEachPart(m_scene, [&](Id, const Part& part) {
            for (const Particle& particle : part.particles) {
                const int place = m_index.particle(particle.id);
                if (place < 0 || !isFree(particle))
                    continue;
                const Hold& hold = m_holds[std::size_t(place)];
                const double weight = gravity * particle.mass;
                if (hold.isTaut && !hold.isUnlimited && weight > hold.strength
                    && !liesOnCollider(m_scene, particle.position))
                    add("weight beyond strength", Severity::Warning,
                        sentence(part, particle, weight, hold), particle.id);
            }
        });
    }

private:
    static Message sentence(const Part& part, const Particle& particle, double weight,
                            const Hold& hold)
    {
        const Message name = subjectOf(Kind::Particle, particle.id);
        const Message mass = Message::number("%.4g", particle.mass);
        const Message pull = Message::number("%.4g", weight);
        const Message strength = Message::number("%.4g", hold.strength);
        return hold.links == 1
                   ? Message("%1 of %2, of %3 kg, weighs %4 N, and the link that holds it breaks "
                             "at %5 N: make it lighter, or the link stronger.",
                             name, part.name, mass, pull, strength)
                   : Message("%1 of %2, of %3 kg, weighs %4 N, and the %5 links that hold it break "
                             "at %6 N together at best: make it lighter, or the links stronger or "
                             "more.",
                             name, part.name, mass, pull, hold.links, strength);
    }

    void takeLink(const Link& link)
    {
        const int from = m_index.particle(link.from), to = m_index.particle(link.to);
        if (from < 0 || to < 0)
            return;
        takeEnd(link, std::size_t(from), std::size_t(to));
        takeEnd(link, std::size_t(to), std::size_t(from));
    }

    void takeEnd(const Link& link, std::size_t end, std::size_t other)
    {
        Hold& hold = m_holds[end];
        const Vec3 way = m_particles[other]->position - m_particles[end]->position;
        const int at = m_index.material(link.material);
        const TearLimit tear =
            at < 0 ? TearLimit()
                   : linkTearOf(std::get<Material>(m_scene.items[std::size_t(at)].item), link.role,
                                link.width, link.tearLimit, link.strengthFactor);
        const bool canProp = link.resists != Resists::Tension && !(way.dot(m_up) > 0.0);
        if (tear.rule != TearRule::Force || canProp || link.resists == Resists::Compression) {
            hold.isUnlimited = true;
            return;
        }
        hold.strength += tear.limit;
        ++hold.links;
        hold.isTaut |= way.norm() >= slack * link.restLength;
    }

    void holdForGood(Id particle)
    {
        if (const int place = m_index.particle(particle); place >= 0)
            m_holds[std::size_t(place)].isUnlimited = true;
    }

    const Scene& m_scene;
    const ElementIndex& m_index;
    Vec3 m_up;
    std::vector<const Particle*> m_particles;
    std::vector<Hold> m_holds; // [particles]
};

} // namespace

void checkWeights(const Scene& scene, const ElementIndex& index, const AddFinding& add)
{
    if (scene.settings.gravity.norm() > 0.0 && hasSupport(scene))
        Weights(scene, index).tell(add);
}

} // namespace ripstop
