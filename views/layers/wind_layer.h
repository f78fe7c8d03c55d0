// The wind around what is shown, as arrows on a grid; off at first.
//
// windField() says where arrows stand and which wind they show: the mean wind of the scene at that
// place (profiles over height, jets) and the gust of the frame. The layer scales and draws them.
#pragma once

#include "layers/arrow_set.h"
#include "layers/layer.h"

#include <vector>

namespace ripstop {

// One arrow of the wind field.
struct WindArrow
{
    Vec3 place;    // m, its middle
    Vec3 velocity; // m/s
};

// The wind on a grid around what is shown. The grid stands still in the world: its step is a round
// number of metres, and its places are multiples of it (half steps in height). Places below y = 0
// and places where the air is calm get no arrow.
//     gust    m/s, of the moment, added everywhere
//     bounds  m, of what is shown; empty for nothing
std::vector<WindArrow> windField(const Scene& scene, const Vec3& gust,
                                 const Eigen::AlignedBox3d& bounds);

// Draws the arrows of the wind field. The longest arrow is nearly as long as a step of the grid.
class WindLayer final : public Layer
{
public:
    WindLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    ArrowSet m_arrows;
    bool m_shown = false;
};

} // namespace ripstop
