// The constructor says how the surface lies in depth and what the cloth is. rebuild() turns the
// panels of a new layout to face alike, selects those that are shown and not gone, and places the
// cloth; update() finds the normals of the frame and paints, by cells for colours of materials and
// loads of panels, by points for quantities that particles have.
#include "layers/panel_layer.h"

#include "look/ripstop_image.h"

#include <vtkRenderer.h>

namespace ripstop {

PanelLayer::PanelLayer()
{
    m_mapper->SetInputData(m_mesh);
    // The surface lies behind the links and particles that are in it, or they would flicker.
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 2.0);
    m_actor->SetMapper(m_mapper);

    m_normals->SetNumberOfComponents(3);
    m_places->SetNumberOfComponents(2);

    m_cloth->SetInputData(ripstopImage());
    m_cloth->RepeatOn();
    m_cloth->MipmapOn();
    m_cloth->InterpolateOn();

    vtkProperty& property = *m_actor->GetProperty();
    property.SetInterpolationToPhong();
    property.SetSpecularPower(24.0);
}

void PanelLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

// llvmpipe of Mesa 22 walks over every texel below a pixel, of which there is no end where a panel
// is seen on edge: one picture could take minutes.
void PanelLayer::setSoftware(bool isSoftware)
{
    constexpr float onCard = 8.0F;
    m_cloth->SetMaximumAnisotropicFiltering(isSoftware ? 1.0F : onCard);
}

void PanelLayer::rebuild(const Picture& picture)
{
    if (m_layout != picture.frame.layout) {
        m_layout = picture.frame.layout;
        m_panels = facingAlike(m_layout->panelCorners);
    }
    selectPanels(picture);
    placeTexture(picture);

    // a quantity is read from its colour, so light may change that less
    const bool isMaterial = picture.colorBy == ColorBy::Material;
    vtkProperty& property = *m_actor->GetProperty();
    property.SetAmbient(isMaterial ? 0.30 : 0.55);
    property.SetDiffuse(isMaterial ? 0.75 : 0.48);
    property.SetSpecular(isMaterial ? 0.12 : 0.0);
}

void PanelLayer::selectPanels(const Picture& picture)
{
    m_present.assign(m_panels.size(), 0);
    m_drawn.clear();
    std::vector<Corners> corners;
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        if (picture.frame.gone[i] || !picture.look.panelShown[i])
            continue;
        m_present[i] = 1;
        m_drawn.push_back(int(i));
        corners.push_back(m_panels[i]);
    }
    m_mesh->SetPolys(cellsOf<3>(corners));
}

void PanelLayer::placeTexture(const Picture& picture)
{
    const auto& texture = picture.look.texture;
    const bool textured = !texture.empty() && picture.colorBy == ColorBy::Material;
    m_actor->SetTexture(textured ? m_cloth.Get() : nullptr);
    m_mesh->GetPointData()->SetTCoords(textured ? m_places.Get() : nullptr);
    if (!textured)
        return;
    m_places->SetNumberOfTuples(vtkIdType(texture.size()));
    std::ranges::copy(texture, reinterpret_cast<std::array<float, 2>*>(m_places->GetPointer(0)));
    m_places->Modified();
}

void PanelLayer::update(const Picture& picture)
{
    if (m_drawn.empty())
        return;
    const auto& position = picture.frame.position;
    m_normals->SetNumberOfTuples(vtkIdType(position.size()));
    smoothNormals(
        m_panels, m_present, position,
        {reinterpret_cast<std::array<float, 3>*>(m_normals->GetPointer(0)), position.size()});
    m_normals->Modified();
    m_mesh->GetPointData()->SetNormals(m_normals);
    m_mesh->SetPoints(picture.points);
    paint(picture);
    m_mesh->Modified();
}

void PanelLayer::paint(const Picture& picture)
{
    if (picture.values.particle.empty() || !picture.values.panel.empty()) {
        const std::span<Color> colors = m_colors.resized(m_drawn.size());
        for (std::size_t i = 0; i < m_drawn.size(); ++i)
            colors[i] = picture.values.panel.empty()
                            ? picture.look.panelColor[m_drawn[i]]
                            : picture.colorOf(picture.values.panel[m_drawn[i]]);
        colorByCells(*m_mesh, *m_mapper, m_colors);
    } else {
        const std::span<Color> colors = m_colors.resized(picture.values.particle.size());
        for (std::size_t i = 0; i < colors.size(); ++i)
            colors[i] = picture.colorOf(picture.values.particle[i]);
        colorByPoints(*m_mesh, *m_mapper, m_colors);
    }
}

} // namespace ripstop
