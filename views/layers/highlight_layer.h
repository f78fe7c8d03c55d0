// What is selected, in the accent colour: rings, thick lines, a veil over panels.
//
// Where colours show values, a veil would make one value look like another of the legend. Panels
// have their outline then instead of it, and links a halo, inside of which they keep their own.
//
// An item stands for its elements: a part, a material or a group lights up as a whole. Cells are
// chosen in rebuild(), which the stage also calls when the selection alone has changed; points are
// those of the picture.
#pragma once

#include "layers/layer.h"
#include "layers/tube_set.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

namespace ripstop {

class HighlightLayer final : public Layer
{
public:
    HighlightLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    struct Overlay
    {
        vtkNew<vtkPolyData> data;
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
    };
    Overlay m_rings, m_lines, m_veil;
    TubeSet m_halo;
};

} // namespace ripstop
