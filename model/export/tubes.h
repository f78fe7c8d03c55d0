// Lines and spars as round tubes, for programs that draw nothing of an edge: Blender, in what it
// renders. Each link with a thickness (derived/link_thickness.h) is a tube of six sides from end to
// end, open at both. Tubes of links that have shrunk to a point are that point.
#pragma once

#include "export/surface.h"

#include <span>
#include <vector>

namespace ripstop {

class Tubes
{
public:
    // Of those lines of a surface that are round. Their sides are counted from a direction that is
    // taken from where the lines are there, so that they do not spin while lines turn.
    explicit Tubes(const Surface& lines);

    static constexpr std::size_t sides = 6;
    static constexpr std::size_t vertices = 2 * sides; // of a tube: first those around its start

    bool empty() const { return m_tubes.empty(); }

    // Their mesh where the lines are at first.
    const Surface& surface() const { return m_surface; }

    // [tubes x vertices] m, where the vertices of the lines are at `places`.
    std::vector<Eigen::Vector3f> positions(std::span<const Eigen::Vector3f> places) const;

private:
    struct Tube
    {
        std::array<int, 2> ends;
        float radius;            // m
        Eigen::Vector3f along;   // 1, at first
        Eigen::Vector3f outward; // 1, at first, to where sides are counted from
    };

    std::vector<Tube> m_tubes;
    Surface m_surface;
};

} // namespace ripstop
