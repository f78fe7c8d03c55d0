#include "layers/highlight_layer.h"

#include "base/key_index.h"
#include "select/elements.h"

#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

namespace ripstop {
namespace {

constexpr double ringSize = 15.0;    // pixels
constexpr double outlineWidth = 4.0; // pixels

constexpr const char* ring = R"(//VTK::Light::Impl
  float reach = 2.0 * length(gl_PointCoord - vec2(0.5));
  if (reach > 1.0 || reach < 0.62) discard;
)";

} // namespace

HighlightLayer::HighlightLayer()
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings}) {
        overlay->mapper->SetInputData(overlay->data);
        overlay->mapper->ScalarVisibilityOff();
        overlay->mapper->SetResolveCoincidentTopologyToPolygonOffset();
        overlay->mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -2.0);
        overlay->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -6.0);
        overlay->mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-60.0);
        overlay->actor->SetMapper(overlay->mapper);
        overlay->actor->GetProperty()->LightingOff();
    }
    m_veil.actor->GetProperty()->SetOpacity(0.45);
    m_rings.actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                                     ring, false);
}

void HighlightLayer::addTo(vtkRenderer& renderer)
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings})
        renderer.AddActor(overlay->actor);
}

void HighlightLayer::setShown(bool shown)
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings})
        overlay->actor->SetVisibility(shown);
}

void HighlightLayer::rebuild(const Picture& picture)
{
    const std::vector<Id> ids = elementsOf(picture.scene, picture.selected);
    KeyIndex among(ids.size());
    for (const Id id : ids)
        among.add(std::uint32_t(id), 0);
    const auto isSelected = [&](std::uint32_t id) { return among(id) != KeyIndex::none; };
    const Layout& layout = picture.layout();
    std::vector<std::array<int, 1>> points;
    std::vector<std::array<int, 2>> lines;
    std::vector<std::array<int, 3>> panels;
    if (!ids.empty()) {
        for (std::size_t i = 0; i < layout.panelId.size(); ++i)
            if (!picture.frame.gone[i] && picture.look.panelShown[i]
                && isSelected(layout.panelId[i]))
                panels.push_back(layout.panelCorners[i]);
        for (std::size_t i = 0; i < layout.links.size(); ++i)
            if (!picture.frame.torn[i] && picture.look.linkShown[i]
                && isSelected(layout.links[i].id))
                lines.push_back({layout.links[i].a, layout.links[i].b});
        for (std::size_t i = 0; i < layout.particleId.size(); ++i)
            if (picture.look.particleShown[i] && isSelected(layout.particleId[i]))
                points.push_back({int(i)});
    }
    m_rings.data->SetVerts(cellsOf<1>(points));
    m_lines.data->SetLines(cellsOf<2>(lines));
    m_veil.data->SetPolys(cellsOf<3>(panels));

    // a whole part lights up gently; a few elements stand out
    const bool many = points.size() + lines.size() > 200;
    m_rings.actor->GetProperty()->SetPointSize(
        float(picture.pixelRatio * (many ? 0.5 : 1.0) * ringSize));
    m_lines.actor->GetProperty()->SetLineWidth(
        float(picture.pixelRatio * (many ? 0.5 : 1.0) * outlineWidth));
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings})
        setColor(*overlay->actor->GetProperty(), picture.theme.accent);
}

void HighlightLayer::update(const Picture& picture)
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings}) {
        overlay->data->SetPoints(picture.points);
        overlay->data->Modified();
    }
}

} // namespace ripstop
