// Colliders that have a surface, where the frame has them.
//
// Each is an actor of its own with the matrix of its collider, so that one that moves, turns or
// grows costs no new surface. Actors are kept from one rebuild to the next while body and surface
// are the same. A selected collider has the accent colour, a landscape that of the ground. Planes
// are drawn by the ground layer.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"
#include "look/collider_geometry.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

namespace ripstop {

class ColliderLayer final : public Layer
{
public:
    void addTo(vtkRenderer& renderer) override { m_renderer = &renderer; }
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    struct Drawn
    {
        Id collider;
        vtkSmartPointer<vtkPolyData> surface;
        vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
        vtkSmartPointer<vtkMatrix4x4> matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    };

    Drawn taken(const ColliderBody& body); // the actor that is drawn already, or a new one

    vtkRenderer* m_renderer = nullptr;
    std::vector<Drawn> m_drawn;
    bool m_shown = true;
};

} // namespace ripstop
