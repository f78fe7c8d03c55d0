#pragma once

#include "viewport/layer.h"
#include "viewport/vtk_data.h"

#include <vtkActor.h>
#include <vtkSphereSource.h>

namespace ripstop {

// Sphere colliders. A selected one has the accent colour.
class ColliderLayer final : public Layer
{
public:
    ColliderLayer();

    void addTo(vtkRenderer& renderer) override { m_renderer = &renderer; }
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture&) override {}

private:
    vtkRenderer* m_renderer = nullptr;
    vtkNew<vtkSphereSource> m_sphere;
    vtkNew<vtkPolyDataMapper> m_mapper;
    std::vector<vtkNew<vtkActor>> m_actors;
    bool m_shown = true;
};

} // namespace ripstop
