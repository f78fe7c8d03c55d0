// The fabric, shaded as a smooth surface that is lit from both sides.
//
// Panels are turned to face alike once per layout; normals are found anew for each frame. Panels
// have the colour of their material, with cloth where particles have places on it, or the colour of
// the quantity that the view shows. The shadow layer draws the same mesh.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"
#include "look/fabric.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkTexture.h>

namespace ripstop {

class PanelLayer final : public Layer
{
public:
    PanelLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override { m_actor->SetVisibility(shown); }
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

    // Whether OpenGL runs in software, where cloth that is seen at a slant is not sharpened.
    void setSoftware(bool isSoftware);

    vtkPolyData& mesh() { return *m_mesh.Get(); }

private:
    void selectPanels(const Picture& picture);
    void placeTexture(const Picture& picture);
    void paint(const Picture& picture);

    std::shared_ptr<const Layout> m_layout;
    std::vector<Corners> m_panels;       // of the layout, facing alike
    std::vector<std::uint8_t> m_present; // [panels] drawn
    std::vector<int> m_drawn;            // [cells] index of the panel
    ColorArray m_colors;
    vtkNew<vtkFloatArray> m_normals;
    vtkNew<vtkFloatArray> m_places;
    vtkNew<vtkTexture> m_cloth;
    vtkNew<vtkPolyData> m_mesh;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
