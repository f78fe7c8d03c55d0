// A person to compare sizes with, 1.75 m tall, who stands in a scene that has nothing in it yet.
#pragma once

#include "layers/layer.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace ripstop {

// Whether a scene has no part and no collider.
bool hasNothing(const Scene& scene);

class PersonLayer final : public Layer
{
public:
    PersonLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture&) override {}

private:
    bool m_shown = true;
    bool m_isWanted = false;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
