// What hides what: the panels and colliders between the eye and a place.
//
// Panels are sorted into cells of the picture, so that each question meets only the few that lie
// over its place. The answer is that of the ray itself: no pixel is too coarse for it.
#pragma once

#include "camera/camera_projection.h"

#include <span>

namespace ripstop {

class Occlusion
{
public:
    // For questions about places within `box` of the picture, pixels.
    //   points  [particles]  where they are in the picture
    Occlusion(const CameraView& view, std::span<const OnScreen> points,
              const Eigen::AlignedBox2d& box, bool panelsHide);

    // A place of an element, and the particles of that element. Panels that have all of them as
    // corners do not hide it. Those that have some do when they lie more than `slack` before it:
    // a link across a fold of the fabric counts as in the fabric.
    struct Spot
    {
        Vec3 place; // m
        std::span<const int> particles;
        double slack = 0.0; // m
    };
    static double foldOf(double linkLength) { return 0.05 * linkLength; } // m, slack of a link

    // True when a panel or a collider lies between the eye and the spot.
    bool hides(const Spot& spot) const;

    // The first panel on the ray through a place of the picture, and how far away it is, m; -1 and
    // infinity when there is none.
    struct Met
    {
        int panel;
        double distance;
    };
    Met firstPanel(double x, double y) const;

private:
    std::span<const int> panelsAt(double x, double y) const;
    Eigen::AlignedBox2d boundsOf(int panel, std::span<const OnScreen> points) const; // pixels
    double distanceToPanel(const CameraProjection::Ray& ray, int panel) const;       // m

    CameraView m_view;
    CameraProjection m_projection;
    Eigen::AlignedBox2d m_box; // of the cells, pixels
    int m_side = 1;            // cells along each side
    std::vector<int> m_first;  // [cells + 1] where the panels of a cell begin in m_panels
    std::vector<int> m_panels;
};

} // namespace ripstop
