#include "look/scene_frame.h"

#include "scene/wind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <unordered_map>

namespace ripstop {
namespace {

using Indices = std::unordered_map<std::uint32_t, int>; // of particles, by id

void addParticles(const Part& part, Layout& layout, Frame& frame, Indices& index)
{
    for (const Particle& particle : part.particles) {
        index.emplace(std::uint32_t(particle.id), int(frame.position.size()));
        layout.particleId.push_back(std::uint32_t(particle.id));
        layout.pinned.push_back(particle.pinned);
        if (!particle.pinned && particle.guide != Guide::None)
            layout.guided.push_back(
                {int(frame.position.size()), particle.guide, particle.guideAxis.normalized()});
        frame.position.push_back(particle.position);
        frame.velocity.push_back(particle.velocity);
    }
}

// Elements with ends that do not exist are left out: the problems list names them.
void addLinks(const Part& part, Layout& layout, Frame& frame, const Indices& index)
{
    for (const Link& link : part.links) {
        const auto from = index.find(std::uint32_t(link.from));
        const auto to = index.find(std::uint32_t(link.to));
        if (from == index.end() || to == index.end())
            continue;
        const int a = from->second, b = to->second;
        layout.links.push_back({std::uint32_t(link.id), link.kind, a, b, link.restLength});
        const double length = (frame.position[b] - frame.position[a]).norm();
        frame.strain.push_back(link.restLength > 0.0 ? length / link.restLength - 1.0 : 0.0);
    }
}

void addPanels(const Part& part, Layout& layout, const Indices& index)
{
    for (const Panel& panel : part.panels) {
        const auto a = index.find(std::uint32_t(panel.a));
        const auto b = index.find(std::uint32_t(panel.b));
        const auto c = index.find(std::uint32_t(panel.c));
        if (a == index.end() || b == index.end() || c == index.end())
            continue;
        layout.panelId.push_back(std::uint32_t(panel.id));
        layout.panelCorners.push_back({a->second, b->second, c->second});
    }
}

} // namespace

std::shared_ptr<const Frame> sceneFrame(const Scene& scene)
{
    auto layout = std::make_shared<Layout>();
    auto frame = std::make_shared<Frame>();
    Indices index;
    forEachPart(scene, [&](Id, const Part& part) { addParticles(part, *layout, *frame, index); });
    forEachPart(scene, [&](Id, const Part& part) {
        addLinks(part, *layout, *frame, index); // links may join parts, so all particles come first
        addPanels(part, *layout, index);
    });
    frame->tension.assign(layout->links.size(), 0.0);
    frame->torn.assign(layout->links.size(), 0);
    frame->panelLoad.assign(layout->panelId.size(), Vec3::Zero());
    frame->gone.assign(layout->panelId.size(), 0);
    frame->layout = std::move(layout);
    Eigen::AlignedBox3d box;
    for (const Vec3& place : frame->position)
        box.extend(place);
    frame->wind = meanWindAt(scene, box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center()));
    return frame;
}

bool hasNothing(const Scene& scene)
{
    return std::ranges::none_of(scene.items, [](const Entry& entry) {
        return std::holds_alternative<Part>(entry.item)
               || std::holds_alternative<Collider>(entry.item);
    });
}

} // namespace ripstop
