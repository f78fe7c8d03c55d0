// Ends says what ends at the particles of fabric parts at which someone may be. peopleOf() then
// walks over the controls (hands and pilots) and over these particles (jumpers); the heading of a
// craft in its design is that of its velocity, or of the axis along which its weight is shifted.
#include "look/people.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>

namespace ripstop {
namespace {

constexpr double lightest = 15.0;  // kg, of who jumps
constexpr double heaviest = 250.0; // kg
constexpr std::size_t fewestLines = 3;
constexpr double armsApart = 2.0;  // m, that two hands of one person may be, at most
constexpr double samePlace = 1e-6; // m
constexpr int fewestWires = 3;

bool mayBeSomeone(const Particle& particle)
{
    return !particle.pinned && particle.mass >= lightest && particle.mass <= heaviest;
}

// What ends at the particles at which someone may be; those are few, also where there are a hundred
// thousand.
class Ends
{
public:
    Ends(const Scene& scene, const Layout& layout)
        : m_layout(layout)
    {
        std::set<Id> targets;
        for (const Entry& entry : scene.items)
            if (const Control* control = std::get_if<Control>(&entry.item))
                targets.insert(control->targets.begin(), control->targets.end());
        forEachPart(scene, [&](Id, const Part& part) {
            if (!part.panels.empty() && part.shown)
                add(part, targets);
        });
    }

    struct End
    {
        const Part* part = nullptr;
        const Particle* particle = nullptr;
        std::vector<Id> lines; // their other ends
        bool isFabric = false; // threads or panels end there
    };
    const End* at(Id particle) const
    {
        const auto found = m_ends.find(particle);
        return found == m_ends.end() ? nullptr : &found->second;
    }
    std::vector<int> indices(const std::vector<Id>& particles) const
    {
        std::vector<int> list;
        for (const Id id : particles) {
            const auto found = std::ranges::find(m_layout.particleId, std::uint32_t(id));
            if (found != m_layout.particleId.end())
                list.push_back(int(found - m_layout.particleId.begin()));
        }
        return list;
    }
    const std::map<Id, End>& all() const { return m_ends; }

private:
    void add(const Part& part, const std::set<Id>& targets)
    {
        std::map<Id, End> ends;
        for (const Particle& particle : part.particles)
            if (mayBeSomeone(particle) || targets.contains(particle.id))
                ends[particle.id] = {&part, &particle, {}, false};
        if (ends.empty())
            return;
        for (const Link& link : part.links)
            for (const auto& [end, other] : {std::pair(link.from, link.to), {link.to, link.from}})
                if (const auto found = ends.find(end); found != ends.end()) {
                    found->second.lines.push_back(other);
                    found->second.isFabric |= link.role != LinkRole::Line;
                }
        for (const Panel& panel : part.panels)
            for (const Id corner : {panel.a, panel.b, panel.c})
                if (const auto found = ends.find(corner); found != ends.end())
                    found->second.isFabric = true;
        m_ends.merge(ends);
    }

    const Layout& m_layout;
    std::map<Id, End> m_ends;
};

// Particles of the part that lie farthest ahead, astern, left and right in the design.
std::vector<int> marksOf(const Ends& ends, const Part& part, const Vec3& ahead)
{
    const Vec3 forward = Vec3(ahead.x(), 0.0, ahead.z()).normalized();
    const Vec3 right = forward.cross(Vec3::UnitY());
    std::vector<Id> found;
    for (const Vec3& way : {forward, Vec3(-forward), Vec3(-right), right})
        found.push_back(std::ranges::max_element(part.particles, {}, [&](const Particle& particle) {
                            return particle.position.dot(way);
                        })->id);
    return ends.indices(found);
}

Person hanging(Pose pose, const Ends& ends, Id weight, const Vec3& ahead)
{
    const Ends::End& end = *ends.at(weight);
    return {
        pose, ends.indices({weight}), ends.indices(end.lines), marksOf(ends, *end.part, ahead), {}};
}

// Off the fabric, where most of the wires meet that are seen and come from what carries this
// weight.
std::vector<Id> footBelow(const Scene& scene, const Ends::End& weight)
{
    const std::set<Id> carriers(weight.lines.begin(), weight.lines.end());
    std::map<Id, int> wires;
    for (const Link& link : weight.part->links) {
        const Material* material = findItem<Material>(scene, link.material);
        if (link.role != LinkRole::Line || !material || !material->shown)
            continue;
        for (const auto& [from, to] : {std::pair(link.from, link.to), {link.to, link.from}})
            if (carriers.contains(from) && !carriers.contains(to) && to != weight.particle->id)
                ++wires[to];
    }
    for (const Panel& panel : weight.part->panels)
        for (const Id corner : {panel.a, panel.b, panel.c})
            wires.erase(corner);
    const auto foot = std::ranges::max_element(wires, {}, &std::pair<const Id, int>::second);
    return foot == wires.end() || foot->second < fewestWires ? std::vector<Id>()
                                                             : std::vector{foot->first};
}

bool isHand(const Ends::End* end) { return end && end->particle->pinned && !end->isFabric; }

// The hands of a control: one, or two apart. Particles in one place are one hand: that at which a
// line ends.
std::vector<Id> handsOf(const Ends& ends, const Control& control)
{
    std::vector<Id> hands;
    for (const Id target : control.targets) {
        const Ends::End* const end = ends.at(target);
        if (!isHand(end))
            return {};
        const auto isThere = [&](Id hand) {
            return (ends.at(hand)->particle->position - end->particle->position).norm() < samePlace;
        };
        if (!end->lines.empty() && std::ranges::none_of(hands, isThere))
            hands.push_back(target);
    }
    return hands;
}

bool mayShare(const Ends& ends, const std::vector<Id>& hands)
{
    return hands.size() == 2
           && (ends.at(hands[0])->particle->position - ends.at(hands[1])->particle->position).norm()
                  < armsApart;
}

void addHolders(const Scene& scene, const Ends& ends, std::vector<Person>& people)
{
    std::vector<Id> hands;
    for (const Entry& entry : scene.items)
        if (const Control* control = std::get_if<Control>(&entry.item);
            control && control->kind == ControlKind::Move)
            for (const Id hand : handsOf(ends, *control))
                if (std::ranges::find(hands, hand) == hands.end())
                    hands.push_back(hand);
    const auto add = [&](const std::vector<Id>& held) {
        std::vector<Id> others;
        for (const Id hand : held)
            others.push_back(ends.at(hand)->lines.front());
        people.push_back({Pose::Standing, ends.indices(held), ends.indices(others), {}, {}});
    };
    if (mayShare(ends, hands))
        return add(hands);
    for (const Id hand : hands)
        add({hand});
}

void addPilots(const Scene& scene, const Ends& ends, std::vector<Person>& people,
               std::set<Id>& taken)
{
    for (const Entry& entry : scene.items) {
        const Control* control = std::get_if<Control>(&entry.item);
        if (!control || control->kind != ControlKind::WeightShift)
            continue;
        for (const Id target : control->targets) {
            const Ends::End* const end = ends.at(target);
            if (!end || end->particle->pinned || !taken.insert(target).second)
                continue;
            const Vec3 level = end->particle->velocity.cwiseProduct(Vec3(1.0, 0.0, 1.0));
            Person pilot =
                hanging(Pose::Prone, ends, target, level.norm() > 1.0 ? level : control->axis);
            pilot.bar = ends.indices(footBelow(scene, *end));
            people.push_back(std::move(pilot));
        }
    }
}

void addJumpers(const Ends& ends, std::vector<Person>& people, const std::set<Id>& taken)
{
    for (const auto& [id, end] : ends.all())
        if (mayBeSomeone(*end.particle) && !end.isFabric && end.lines.size() >= fewestLines
            && !taken.contains(id))
            people.push_back(hanging(Pose::Upright, ends, id, Vec3::UnitX()));
}

} // namespace

std::vector<Person> peopleOf(const Scene& scene, const Layout& layout)
{
    const Ends ends(scene, layout);
    std::vector<Person> people;
    std::set<Id> taken;
    addHolders(scene, ends, people);
    addPilots(scene, ends, people, taken);
    addJumpers(ends, people, taken);
    return people;
}

} // namespace ripstop
