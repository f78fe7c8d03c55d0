// Lines along the ways that particles have come, fading towards their ends; off at first.
//
// The particles are those that trailed() names: selected ones, or those that probes look at. While
// it is off, nothing is collected, and switching it begins anew.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"
#include "look/trails.h"

#include <vtkActor.h>
#include <vtkPoints.h>

namespace ripstop {

class TrailLayer final : public Layer
{
public:
    TrailLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    void draw(const Theme& theme);

    Trails m_trails;
    bool m_shown = false;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkPolyData> m_lines;
    vtkNew<vtkUnsignedCharArray> m_colors; // with opacity
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
