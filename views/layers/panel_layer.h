// The fabric, shaded as a smooth surface that is lit from both sides.
//
// Panels are turned to face alike and laid on one sheet of cloth once per layout; normals are found
// anew for each frame, as is the shade that fabric throws on itself. Panels have the colour of
// their material and look like cloth (layers/cloth_shader.h), with pictures and bands on top, or
// they have the colour of the quantity that the view shows. Vertices are those of the cloth, of
// which a particle may have several. The shadow layer draws the same mesh.
#pragma once

#include "layers/band_drawing.h"
#include "layers/layer.h"
#include "layers/printed_cloth.h"
#include "layers/vtk_data.h"
#include "look/fabric.h"
#include "look/sky_shade.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPropAssembly.h>

namespace ripstop {

class PanelLayer final : public Layer
{
public:
    PanelLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

    vtkPolyData& mesh() { return *m_mesh.Get(); }

private:
    void selectPanels(const Picture& picture);
    void takeBands(const Picture& picture);
    void takePrints(const Picture& picture);
    void takeLight(const Picture& picture);
    void layCloth(const Picture& picture);
    void takePoints(const Picture& picture);
    void castShades(std::span<const Vec3> position);
    void paint(const Picture& picture);

    std::shared_ptr<const Layout> m_layout;
    std::vector<Corners> m_panels;       // of the layout, facing alike
    std::vector<std::uint8_t> m_present; // [panels] drawn
    std::vector<int> m_drawn;            // [cells] index of the panel
    struct SeenLook                      // what the bands follow from
    {
        std::vector<Color> panelColor, linkColor;
        std::vector<Look::Form> linkForm;
        std::vector<std::uint8_t> linkShown;

        friend bool operator==(const SeenLook&, const SeenLook&) = default;
    };
    SeenLook m_seen;
    Bands m_bands;
    std::array<BandDrawing, 2> m_bandDrawings{BandDrawing(BandKind::Border),
                                              BandDrawing(BandKind::Sewn)};
    std::vector<std::unique_ptr<PrintedCloth>> m_prints; // as many as there ever were
    std::vector<Look::Cloth> m_cloth;                    // [panels] as it was laid
    std::vector<std::array<ClothPoint, 3>> m_onSheet;    // [panels]
    ClothVertices m_vertices;
    std::vector<std::array<float, 3>> m_normal; // [particles]
    SelfShade m_selfShade;
    SkyShade m_skyShade;
    std::vector<float> m_sunShade;                   // [particles]
    std::vector<std::array<float, 2>> m_aroundShade; // [particles]
    ColorArray m_colors;
    vtkNew<vtkPoints> m_points;      // [vertices]
    vtkNew<vtkFloatArray> m_normals; // [vertices]
    vtkNew<vtkFloatArray> m_onCloth; // [vertices]
    vtkNew<vtkFloatArray> m_shadeOfVertices;
    vtkNew<vtkPolyData> m_mesh;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
    vtkNew<vtkPropAssembly> m_printed; // keeps the place of the pictures before what comes later
};

} // namespace ripstop
