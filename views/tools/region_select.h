// What lies in a part of the picture: the elements that a box or a lasso takes.
//
// Large designs are looked at on several threads, which are started for the call and have ended
// when it returns; the caller sees an ordinary function. The frame is immutable meanwhile.
#pragma once

#include "tools/picker.h"

#include <Eigen/Geometry>

#include <vector>

namespace ripstop {

// A closed outline in the picture, pixels. Where it crosses itself, what it goes around at all is
// inside.
class Region
{
public:
    explicit Region(std::vector<Eigen::Vector2d> outline);

    bool contains(double x, double y) const;
    const Eigen::AlignedBox2d& box() const { return m_box; }

private:
    struct Side
    {
        Eigen::Vector2d from, to;
    };
    Eigen::AlignedBox2d m_box;
    // One line of pixels meets few sides of a lasso, so sides are kept by line.
    std::vector<std::vector<Side>> m_sides;
};

enum class Depth { Visible, Through }; // only what can be seen, or all that lies there

// The ids, ascending, of the particles in the region, the links with both ends in it and the panels
// with all corners in it. Of a link or a panel it is enough that some of it can be seen.
std::vector<Id> elementsIn(const CameraView& view, const Pickable& pickable, const Region& region,
                           Depth depth);

} // namespace ripstop
