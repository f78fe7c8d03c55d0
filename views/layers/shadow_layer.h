// The shadow of the fabric on the first plane collider: it tells how high things are.
//
// It draws the mesh of the panel layer once more, with a matrix that projects it along the rays of
// the sun onto the plane. Without a shown plane that faces the sun there is no shadow.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>

namespace ripstop {

// Direction towards the sun, not of unit length. The stage places its light there, too.
inline const Vec3 sunDirection(0.45, 1.0, 0.55);

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
