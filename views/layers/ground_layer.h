// Planes that are not the ground of the backdrop (backdrop_layer.h), such as slopes: squares of
// 0.1, 1, 10 or 100 m in the colours of that ground, which fade out towards the rim of a disc.
//
// The disc is centred below what is shown and goes with it; its squares stay where they are in the
// world, so that motion can be read against them. It is drawn anew only when it has to move by more
// than a tenth of its radius or off its plane, or when its radius changes.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

#include <memory>

namespace ripstop {

class GroundLayer final : public Layer
{
public:
    void addTo(vtkRenderer& renderer) override { m_renderer = &renderer; }
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    struct Ground;

    void add(Id collider, double pixelRatio);

    vtkRenderer* m_renderer = nullptr;
    std::vector<std::shared_ptr<Ground>> m_grounds;
    bool m_shown = true;
};

// Metres from the middle of the disc to its rim, a round number well beyond what is shown.
double groundRadius(const Eigen::AlignedBox3d& bounds);

// m, the side of the squares of a disc: a power of ten.
double groundSquare(double radius);

} // namespace ripstop
