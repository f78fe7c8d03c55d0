// Pilots, payloads and bobs: free particles that carry a fair share of the mass of their part.
//
// They are drawn as big balls, whether or not particles are shown; Look::isWeight says which they
// are. Those that are people are drawn as such (person_layer.h).
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

namespace ripstop {

class WeightLayer final : public Layer
{
public:
    WeightLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override { m_actor->SetVisibility(shown); }
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
