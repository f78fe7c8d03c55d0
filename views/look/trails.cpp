#include "look/trails.h"

#include "scene/property.h"

#include <algorithm>
#include <limits>

namespace ripstop {

void Trails::follow(std::vector<std::uint32_t> particles)
{
    if (particles == m_particles)
        return;
    const Vec3 nowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    for (Point& point : m_points) {
        std::vector<Vec3> place(particles.size(), nowhere);
        for (std::size_t i = 0; i < particles.size(); ++i)
            if (const auto before = std::ranges::find(m_particles, particles[i]);
                before != m_particles.end())
                place[i] = point.place[std::size_t(before - m_particles.begin())];
        point.place = std::move(place);
    }
    m_particles = std::move(particles);
}

void Trails::add(const Frame& frame)
{
    if (frame.run != m_run || (!m_points.empty() && frame.time < m_points.back().time))
        clear();
    m_run = frame.run;
    if (!m_points.empty() && frame.time - m_points.back().time < closest)
        return;
    Point point{frame.time, {}};
    const std::vector<std::uint32_t>& ids = frame.layout->particleId;
    for (const std::uint32_t id : m_particles) {
        // most layouts are in ascending order of id; what tears have added comes last
        const auto found = std::ranges::find(ids, id);
        point.place.push_back(found == ids.end()
                                  ? Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()))
                                  : frame.position[std::size_t(found - ids.begin())]);
    }
    m_points.push_back(std::move(point));
    while (frame.time - m_points.front().time > length)
        m_points.pop_front();
}

void Trails::clear() { m_points.clear(); }

std::vector<std::uint32_t> trailed(const Scene& scene, const std::vector<Id>& selected)
{
    std::vector<std::uint32_t> particles;
    const auto add = [&](Id id) {
        const auto ref = find(scene, id);
        if (ref && kindOf(*ref) == Kind::Particle && particles.size() < Trails::most
            && std::ranges::find(particles, std::uint32_t(id)) == particles.end())
            particles.push_back(std::uint32_t(id));
    };
    for (std::size_t i = 0; i < std::min(selected.size(), 4 * Trails::most); ++i)
        add(selected[i]);
    if (particles.empty())
        for (const Entry& entry : scene.items)
            if (const auto* probe = std::get_if<Probe>(&entry.item))
                add(probe->target);
    return particles;
}

} // namespace ripstop
