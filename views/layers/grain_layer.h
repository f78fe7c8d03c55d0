// The grain: on each panel that carries the pull of a fabric a short stroke along its warp, where
// that is at the moment.
//
// Strokes are as long as a share of the panel is wide; of very many panels every n-th has one. They
// are drawn when they are asked for only.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkPoints.h>

namespace ripstop {

class GrainLayer final : public Layer
{
public:
    GrainLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    bool m_shown = false;
    std::vector<std::size_t> m_panels; // that have a stroke
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkPolyData> m_data;
    struct Pen
    {
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
    };
    Pen m_edge; // around the strokes, so that they are seen on any colour
    Pen m_ink;
};

// The ends of the stroke on a panel with these corners, m.
std::array<Vec3, 2> grainStroke(const Look::Warp& warp, const std::array<Vec3, 3>& corners);

} // namespace ripstop
