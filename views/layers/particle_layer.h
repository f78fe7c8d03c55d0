// Particles as small balls, and pinned particles as diamonds.
//
// Both are points of a size in pixels, so that they look alike from far and near. They are two
// layers, as pins stay shown when particles are hidden.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

namespace ripstop {

// Particles as small balls.
class ParticleLayer final : public Layer
{
public:
    ParticleLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override { m_actor->SetVisibility(shown); }
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    ColorArray m_colors;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

// Pinned particles as diamonds, whether or not particles are shown.
class PinLayer final : public Layer
{
public:
    PinLayer();

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
