#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

namespace ripstop {

// Particles that are free along a line or in a plane only: a piece of the line with stops at its
// ends, or a square in the plane, where the particle is now. Whether or not particles are shown.
class GuideLayer final : public Layer
{
public:
    GuideLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override { m_actor->SetVisibility(shown); }
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    struct Mark
    {
        int particle;
        std::array<Vec3, 6> corners; // m, from the particle
    };

    std::vector<Mark> m_marks;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
