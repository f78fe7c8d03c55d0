// The shadow of the fabric on landscapes, and on a slope that is not the ground of the backdrop,
// which has softer ones (backdrop_layer.h): it tells how high things are.
//
// It draws the triangles of the panel layer once more, each corner where a ray of the sun through
// it meets the ground; those that miss it with a corner are left out.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

namespace ripstop {

class ShadowLayer final : public Layer
{
public:
    // `fabric` is what the panel layer draws.
    explicit ShadowLayer(vtkPolyData& fabric);

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    vtkPolyData& m_fabric;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkPolyData> m_mesh;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
    bool m_shown = true;
};

} // namespace ripstop
