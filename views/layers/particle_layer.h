// Particles as small balls, and pinned particles as diamonds.
//
// Both are points of a size in pixels, so that they look alike from far and near. They are two
// layers, as pins stay shown when particles are hidden. So do particles that nothing holds, since
// without a dot nothing would be seen of them.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

namespace ripstop {

// Particles as small balls.
class ParticleLayer final : public Layer
{
public:
    ParticleLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override; // the others are always
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    void takeCells();

    bool m_isShown = true;
    vtkSmartPointer<vtkCellArray> m_all;
    vtkSmartPointer<vtkCellArray> m_loose; // those that nothing holds
    double m_pixelRatio = 1.0;
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
