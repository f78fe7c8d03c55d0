// rebuild() finds what is selected of the picture. Where colours show values it turns panels into
// their outline, the sides that one of them has alone, and leaves out the mesh inside of it; all of
// that goes into the halo, which lies behind what it surrounds. update() takes the points.
#include "layers/highlight_layer.h"

#include "base/key_index.h"
#include "select/elements.h"

#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

namespace ripstop {
namespace {

constexpr double ringSize = 15.0;    // pixels
constexpr double outlineWidth = 4.0; // pixels
constexpr double haloBorder = 2.0;   // pixels, on either side of a link

constexpr const char* ring = R"(//VTK::Light::Impl
  float reach = 2.0 * length(gl_PointCoord - vec2(0.5));
  if (reach > 1.0 || reach < 0.62) discard;
)";

// What is selected of a picture and seen there, by the indices of its particles.
struct Cells
{
    std::vector<std::array<int, 1>> points;
    std::vector<TubeSet::Tube> lines;
    std::vector<std::array<int, 3>> panels;
};

Cells selectedIn(const Picture& picture)
{
    const std::vector<Id> ids = elementsOf(picture.scene, picture.selected);
    if (ids.empty())
        return {};
    KeyIndex among(ids.size());
    for (const Id id : ids)
        among.add(std::uint32_t(id), 0);
    const auto isSelected = [&](std::uint32_t id) { return among(id) != KeyIndex::none; };
    const Layout& layout = picture.layout();
    Cells cells;
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        if (!picture.frame.gone[i] && picture.look.panelShown[i] && isSelected(layout.panelId[i]))
            cells.panels.push_back(layout.panelCorners[i]);
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (!picture.frame.torn[i] && picture.look.linkShown[i] && isSelected(layout.links[i].id))
            cells.lines.push_back(
                {layout.links[i].a, layout.links[i].b, picture.look.linkThickness[i]});
    for (std::size_t i = 0; i < layout.particleId.size(); ++i)
        if (picture.look.particleShown[i] && isSelected(layout.particleId[i]))
            cells.points.push_back({int(i)});
    return cells;
}

using Panels = std::span<const std::array<int, 3>>;

// Marks the corners of the panels among so many particles.
std::vector<std::uint8_t> cornersOf(Panels panels, std::size_t particles)
{
    std::vector<std::uint8_t> isCorner(particles, 0);
    for (const auto& corners : panels)
        for (const int corner : corners)
            isCorner[std::size_t(corner)] = 1;
    return isCorner;
}

// The mesh of fabric whose outline is drawn: marks on each thread of it would cover its colour.
void leaveOut(Cells& cells, std::span<const std::uint8_t> isCorner)
{
    const auto isInside = [&](int particle) { return isCorner[std::size_t(particle)] != 0; };
    std::erase_if(cells.points, [&](const auto& point) { return isInside(point[0]); });
    std::erase_if(cells.lines,
                  [&](const auto& line) { return isInside(line.a) && isInside(line.b); });
}

// The sides that belong to one of the panels alone.
std::vector<TubeSet::Tube> outlineOf(Panels panels)
{
    std::vector<std::pair<int, int>> sides;
    for (const auto& [a, b, c] : panels)
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            sides.push_back(std::minmax(from, to));
    std::ranges::sort(sides);
    std::vector<TubeSet::Tube> outline;
    for (auto side = sides.begin(); side != sides.end();) {
        const auto next = std::upper_bound(side, sides.end(), *side);
        if (next - side == 1)
            outline.push_back({side->first, side->second, 0.0});
        side = next;
    }
    return outline;
}

std::vector<std::array<int, 2>> endsOf(std::span<const TubeSet::Tube> lines)
{
    std::vector<std::array<int, 2>> ends;
    for (const TubeSet::Tube& line : lines)
        ends.push_back({line.a, line.b});
    return ends;
}

} // namespace

HighlightLayer::HighlightLayer()
    : m_halo(haloBorder)
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
    m_halo.setShaded(false);
}

void HighlightLayer::addTo(vtkRenderer& renderer)
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings})
        renderer.AddActor(overlay->actor);
    m_halo.addTo(renderer);
}

void HighlightLayer::setShown(bool shown)
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings})
        overlay->actor->SetVisibility(shown);
    m_halo.setShown(shown);
}

void HighlightLayer::rebuild(const Picture& picture)
{
    Cells cells = selectedIn(picture);
    std::vector<TubeSet::Tube> halo;
    if (picture.colorBy != ColorBy::Material) {
        leaveOut(cells, cornersOf(cells.panels, picture.frame.position.size()));
        halo = outlineOf(cells.panels);
        cells.panels.clear();
        std::ranges::move(std::exchange(cells.lines, {}), std::back_inserter(halo));
    }
    m_rings.data->SetVerts(cellsOf<1>(cells.points));
    m_lines.data->SetLines(cellsOf<2>(endsOf(cells.lines)));
    m_veil.data->SetPolys(cellsOf<3>(cells.panels));
    m_halo.rebuild(halo, picture.pixelRatio);

    // a whole part lights up gently; a few elements stand out
    const bool many = cells.points.size() + cells.lines.size() > 200;
    m_rings.actor->GetProperty()->SetPointSize(
        float(picture.pixelRatio * (many ? 0.5 : 1.0) * ringSize));
    m_lines.actor->GetProperty()->SetLineWidth(
        float(picture.pixelRatio * (many ? 0.5 : 1.0) * outlineWidth));
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings})
        setColor(*overlay->actor->GetProperty(), picture.theme.accent);
    m_halo.setColor(picture.theme.accent);
}

void HighlightLayer::update(const Picture& picture)
{
    for (Overlay* overlay : {&m_veil, &m_lines, &m_rings}) {
        overlay->data->SetPoints(picture.points);
        overlay->data->Modified();
    }
    m_halo.update(picture.frame.position);
}

} // namespace ripstop
