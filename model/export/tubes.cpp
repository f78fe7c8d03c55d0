#include "export/tubes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace ripstop {

Tubes::Tubes(const Surface& lines)
{
    m_surface.name = lines.name + " lines";
    m_surface.fabrics = lines.fabrics;
    std::vector<Eigen::Vector3f> places;
    for (const Vec3& place : lines.position)
        places.push_back(place.cast<float>());
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const double thickness = lines.fabrics[lines.lineFabric[i]].thickness;
        if (!(thickness > 0.0))
            continue;
        const auto [a, b] = lines.lines[i];
        const Vec3 way = lines.position[std::size_t(b)] - lines.position[std::size_t(a)];
        const Vec3 along = way.norm() > 0.0 ? Vec3(way.normalized()) : Vec3(Vec3::UnitY());
        m_tubes.push_back({{a, b},
                           float(0.5 * thickness),
                           along.cast<float>(),
                           along.unitOrthogonal().cast<float>()});
        const int first = int((m_tubes.size() - 1) * vertices);
        for (int side = 0; side < int(sides); ++side) {
            const int here = first + side, next = first + (side + 1) % int(sides);
            m_surface.panels.push_back({here, next, next + int(sides)});
            m_surface.panels.push_back({here, next + int(sides), here + int(sides)});
            m_surface.fabric.insert(m_surface.fabric.end(), 2, lines.lineFabric[i]);
        }
    }
    for (const Eigen::Vector3f& place : positions(places))
        m_surface.position.push_back(place.cast<double>());
}

std::vector<Eigen::Vector3f> Tubes::positions(std::span<const Eigen::Vector3f> places) const
{
    std::vector<Eigen::Vector3f> around;
    around.reserve(vertices * m_tubes.size());
    for (const Tube& tube : m_tubes) {
        const Eigen::Vector3f& start = places[std::size_t(tube.ends[0])];
        const Eigen::Vector3f& end = places[std::size_t(tube.ends[1])];
        const Eigen::Vector3f way = end - start;
        const bool isPoint = way.squaredNorm() == 0.0F;
        const auto turn =
            Eigen::Quaternionf::FromTwoVectors(tube.along, isPoint ? tube.along : way);
        const Eigen::Vector3f along = turn * tube.along;
        const Eigen::Vector3f first = (isPoint ? 0.0F : tube.radius) * (turn * tube.outward);
        const Eigen::Vector3f second = along.cross(first);
        for (const Eigen::Vector3f* place : {&start, &end})
            for (std::size_t side = 0; side < sides; ++side) {
                const float angle = float(2.0 * std::numbers::pi * double(side) / double(sides));
                around.push_back(*place + std::cos(angle) * first + std::sin(angle) * second);
            }
    }
    return around;
}

} // namespace ripstop
