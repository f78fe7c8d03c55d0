// Marks of particles that are free along a line or in a plane only.
//
// A piece of the line with stops at its ends, or a square in the plane, stands where the particle
// is at the moment. Marks are shown whether or not particles are; those of pinned or hidden
// particles are not. Their size is a share of what is shown, taken at each rebuild.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

namespace ripstop {

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
