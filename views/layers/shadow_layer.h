// The shadow of the fabric on a slope that is not the ground of the backdrop, which has softer ones
// (backdrop_layer.h): it tells how high things are.
//
// It draws the mesh of the panel layer once more, with a matrix that projects it along the rays of
// the sun onto the plane. Without a shown plane that faces the sun there is no shadow.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"
#include "look/shadow_map.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>

namespace ripstop {

class ShadowLayer final : public Layer
{
public:
    // `fabric` is what the panel layer draws.
    explicit ShadowLayer(vtkPolyData& fabric);

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture&) override {}

private:
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
    vtkNew<vtkMatrix4x4> m_projection;
    bool m_shown = true;
    bool m_hasGround = false;
};

} // namespace ripstop
