// The constructor says how the surface lies in depth. rebuild() turns the panels of a new layout to
// face alike, lays the cloth, and selects those that are shown and not gone; update() finds points
// and normals of the frame and paints, by cells for colours of materials and loads of panels, by
// points for quantities that particles have.
#include "layers/panel_layer.h"

#include "layers/cloth_shader.h"
#include "look/shadow_map.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr std::size_t mostForSky = 20000; // panels; more would take longer than drawing them

} // namespace

PanelLayer::PanelLayer()
{
    m_mapper->SetInputData(m_mesh);
    // The surface lies behind the links and particles that are in it, or they would flicker.
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 2.0);
    m_actor->SetMapper(m_mapper);

    joinCloth(*m_mesh, *m_points, *m_normals, *m_onCloth, *m_shadeOfVertices);
    addClothShader(*m_actor, *m_mapper);
}

void PanelLayer::addTo(vtkRenderer& renderer)
{
    renderer.AddActor(m_actor);
    for (BandDrawing& bands : m_bandDrawings)
        bands.addTo(renderer);
    renderer.AddViewProp(m_printed);
}

void PanelLayer::setShown(bool shown)
{
    m_actor->SetVisibility(shown);
    for (BandDrawing& bands : m_bandDrawings)
        bands.setShown(shown);
    m_printed->SetVisibility(shown);
}

void PanelLayer::rebuild(const Picture& picture)
{
    const bool otherLayout = m_layout != picture.frame.layout;
    if (otherLayout) {
        m_layout = picture.frame.layout;
        m_panels = facingAlike(m_layout->panelCorners);
    }
    if (otherLayout || m_cloth != picture.look.panelCloth)
        layCloth(picture);
    selectPanels(picture);
    takeBands(picture);
    takePrints(picture);
    takeLight(picture);
}

// A quantity is read from its colour, which light would change.
void PanelLayer::takeLight(const Picture& picture)
{
    const bool isMaterial = picture.colorBy == ColorBy::Material;
    std::vector<vtkProperty*> properties{m_actor->GetProperty()};
    for (BandDrawing& bands : m_bandDrawings)
        properties.push_back(&bands.property());
    for (const auto& print : m_prints)
        properties.push_back(print->actor().GetProperty());
    for (vtkProperty* property : properties) {
        property->SetInterpolationToPhong();
        property->SetSpecularPower(24.0);
        property->SetAmbient(isMaterial ? 0.0 : 1.0); // the shader has that of sky and ground
        property->SetDiffuse(isMaterial ? 0.75 : 0.0);
        property->SetSpecular(isMaterial ? 0.08 : 0.0);
    }
    showAs(*m_actor, isMaterial ? Shown::Cloth : Shown::Numbers);
}

void PanelLayer::takeBands(const Picture& picture)
{
    const Look& look = picture.look;
    const SeenLook seen{look.panelColor, look.linkColor, look.linkForm, look.linkShown};
    if (m_bands.panelColor.empty() || m_seen != seen)
        m_bands = bandsOf(m_panels, m_onSheet, *m_layout, look);
    m_seen = seen;
    const bool isMaterial = picture.colorBy == ColorBy::Material;
    for (BandDrawing& bands : m_bandDrawings)
        bands.rebuild(isMaterial ? m_bands.pieces : std::vector<BandPiece>{}, m_vertices,
                      m_present);
}

void PanelLayer::takePrints(const Picture& picture)
{
    const bool isMaterial = picture.colorBy == ColorBy::Material;
    const std::size_t count = isMaterial ? picture.look.prints.size() : 0;
    while (m_prints.size() < count) {
        m_prints.push_back(std::make_unique<PrintedCloth>(*m_mesh));
        m_printed->AddPart(&m_prints.back()->actor());
    }
    std::vector<std::vector<Corners>> corners(m_prints.size());
    for (const int panel : m_drawn)
        if (const int print = picture.look.panelPrint[panel]; print >= 0 && isMaterial)
            corners[print].push_back(m_vertices.corners[panel]);
    for (std::size_t i = 0; i < m_prints.size(); ++i)
        m_prints[i]->rebuild(i < count ? picture.look.prints[i] : Look::Print{}, m_vertices,
                             corners[i]);
}

// Panels that were turned are seen from their other side: their weft runs the other way.
void PanelLayer::layCloth(const Picture& picture)
{
    m_bands = {};
    m_cloth = picture.look.panelCloth;
    m_onSheet.resize(m_panels.size());
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const Look::Cloth& cloth = m_cloth[i];
        const bool isTurned = m_panels[i][1] != m_layout->panelCorners[i][1];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto& [weft, warp] = cloth.place[isTurned ? (3 - corner) % 3 : corner];
            m_onSheet[i][corner] = {isTurned ? -weft : weft, warp, cloth.through, cloth.grid};
        }
    }
    laySideBySide(m_panels, m_onSheet);
    m_vertices = clothVertices(m_panels, m_onSheet, m_layout->particleId.size());

    const auto count = vtkIdType(m_vertices.point.size());
    m_onCloth->SetNumberOfTuples(count);
    std::ranges::copy(m_vertices.point, reinterpret_cast<ClothPoint*>(m_onCloth->GetPointer(0)));
    m_onCloth->Modified();
    m_points->SetNumberOfPoints(count);
    m_normals->SetNumberOfTuples(count);
    m_shadeOfVertices->SetNumberOfTuples(count);
    m_normal.resize(m_layout->particleId.size());
    m_sunShade.resize(m_layout->particleId.size());
    m_aroundShade.assign(m_layout->particleId.size(), {});
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
        corners.push_back(m_vertices.corners[i]);
    }
    m_mesh->SetPolys(cellsOf<3>(corners));
}

void PanelLayer::update(const Picture& picture)
{
    if (m_drawn.empty())
        return;
    takePoints(picture);
    paint(picture);
    m_mesh->Modified();
    for (const auto& print : m_prints)
        print->moved();
}

void PanelLayer::takePoints(const Picture& picture)
{
    const auto& position = picture.frame.position;
    smoothNormals(m_panels, m_present, position, m_normal);
    if (picture.colorBy == ColorBy::Material) // numbers have no light
        castShades(position);
    auto* point = reinterpret_cast<std::array<float, 3>*>(m_points->GetVoidPointer(0));
    auto* normal = reinterpret_cast<std::array<float, 3>*>(m_normals->GetPointer(0));
    auto* shade = reinterpret_cast<Shades*>(m_shadeOfVertices->GetPointer(0));
    for (const int particle : m_vertices.particle) {
        const Vec3& at = position[particle];
        *point++ = {float(at.x()), float(at.y()), float(at.z())};
        *normal++ = m_normal[particle];
        const auto& [along, against] = m_aroundShade[particle];
        *shade++ = {m_sunShade[particle], along, against};
    }
    m_points->Modified();
    m_normals->Modified();
    m_shadeOfVertices->Modified();
    const std::size_t count = m_vertices.particle.size();
    for (BandDrawing& bands : m_bandDrawings)
        bands.update({point - count, count}, {normal - count, count}, {shade - count, count});
}

void PanelLayer::castShades(std::span<const Vec3> position)
{
    m_selfShade.cast(sunDirection.normalized(), position, m_normal, m_panels, m_present,
                     m_sunShade);
    if (m_panels.size() <= mostForSky)
        m_skyShade.cast(position, m_normal, m_panels, m_present, m_aroundShade);
}

void PanelLayer::paint(const Picture& picture)
{
    if (picture.values.particle.empty() || !picture.values.panel.empty()) {
        const std::span<Color> colors = m_colors.resized(m_drawn.size());
        for (std::size_t i = 0; i < m_drawn.size(); ++i)
            colors[i] = picture.values.panel.empty()
                            ? m_bands.panelColor[m_drawn[i]]
                            : picture.colorOf(picture.values.panel[m_drawn[i]]);
        colorByCells(*m_mesh, *m_mapper, m_colors);
    } else {
        const std::span<Color> colors = m_colors.resized(m_vertices.particle.size());
        for (std::size_t i = 0; i < colors.size(); ++i)
            colors[i] = picture.colorOf(picture.values.particle[m_vertices.particle[i]]);
        colorByPoints(*m_mesh, *m_mapper, m_colors);
    }
}

} // namespace ripstop
