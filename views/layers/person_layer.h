// People, to compare sizes with: who holds a kite, hangs below a glider or a parachute, or stands
// in a scene that has nothing yet (look/people.h, look/figure.h).
//
// Their limbs are cones with round ends in one colour, made anew for each frame that they are seen
// in: a body has about a thousand points.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>

namespace ripstop {

class PersonLayer final : public Layer
{
public:
    PersonLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override { m_actor->SetVisibility(shown); }
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    void add(const Limb& limb);

    vtkNew<vtkPoints> m_points;
    vtkNew<vtkFloatArray> m_normals;
    vtkNew<vtkCellArray> m_cells;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
