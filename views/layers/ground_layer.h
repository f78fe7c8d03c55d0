// Planes that are not the ground of the backdrop (backdrop_layer.h), such as slopes: a disc with a
// grid in round metres that fades out towards its rim.
//
// The disc is centred below what is shown and goes with it; its lines stay where they are in the
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

} // namespace ripstop
