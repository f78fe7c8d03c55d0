// The points of all ghosts stand one after the other in one array, and their cells likewise,
// coloured each; cells are made anew only when networks change, points at every frame.
#include "layers/ghost_layer.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

namespace ripstop {

GhostLayer::GhostLayer(Of of)
    : m_of(of)
{
    m_points->SetDataTypeToDouble();
    for (const auto& [actor, data] :
         {std::pair<vtkActor*, vtkPolyData*>{m_panelActor, m_panels}, {m_linkActor, m_links}}) {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        actor->SetMapper(mapper);
        actor->GetProperty()->LightingOff();
        actor->PickableOff();
        actor->VisibilityOff();
        data->SetPoints(m_points);
    }
    m_panelActor->GetProperty()->SetOpacity(0.22);
    m_linkActor->GetProperty()->SetOpacity(0.5);
}

void GhostLayer::addTo(vtkRenderer& renderer)
{
    renderer.AddActor(m_panelActor);
    renderer.AddActor(m_linkActor);
}

void GhostLayer::setShown(bool shown)
{
    m_panelActor->SetVisibility(shown);
    m_linkActor->SetVisibility(shown);
}

void GhostLayer::rebuild(const Picture& picture)
{
    const bool dark = picture.theme.isDark();
    const QColor run = dark ? QColor(0x9a, 0xd0, 0xff) : QColor(0x20, 0x50, 0x90);
    const QColor design = dark ? QColor(0xa5, 0xe0, 0xa0) : QColor(0x2d, 0x6a, 0x2d);
    const QColor color = m_of == Of::Run ? run : design;
    const bool isOther = std::exchange(m_color, color) != color;

    std::vector<std::uint32_t> hidden;
    const Layout& layout = picture.layout();
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (!picture.look.linkShown[i])
            hidden.push_back(layout.links[i].id);
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        if (!picture.look.panelShown[i])
            hidden.push_back(layout.panelId[i]);
    std::ranges::sort(hidden);
    if ((std::exchange(m_hidden, std::move(hidden)) != m_hidden || isOther) && !m_ghosts.empty())
        build();
}

void GhostLayer::show(std::vector<Ghost> ghosts)
{
    std::erase_if(ghosts, [](const Ghost& one) { return !one.frame; });
    setShown(!ghosts.empty());
    const bool same =
        std::ranges::equal(m_ghosts, ghosts, [](const Ghost& before, const Ghost& now) {
            return before.color == now.color && before.frame->layout == now.frame->layout
                   && before.frame->torn == now.frame->torn
                   && before.frame->gone == now.frame->gone;
        });
    m_ghosts = std::move(ghosts);
    std::size_t count = 0;
    for (const Ghost& one : m_ghosts)
        count += one.frame->position.size();
    m_points->SetNumberOfPoints(vtkIdType(count));
    vtkIdType next = 0;
    for (const Ghost& one : m_ghosts)
        for (const Vec3& position : one.frame->position)
            m_points->SetPoint(next++, position.data());
    m_points->Modified();
    if (!same)
        build();
}

void GhostLayer::build()
{
    const auto isHidden = [this](std::uint32_t id) {
        return std::ranges::binary_search(m_hidden, id);
    };
    std::vector<std::array<int, 3>> panels;
    std::vector<std::array<int, 2>> links;
    std::vector<Color> panelColor, linkColor;
    int first = 0; // of the points of a ghost
    for (const Ghost& one : m_ghosts) {
        const Frame& frame = *one.frame;
        const Layout& layout = *frame.layout;
        const Color color = toColor(one.color ? QColor::fromRgb(*one.color) : m_color);
        for (std::size_t i = 0; i < layout.panelCorners.size(); ++i)
            if (!frame.gone[i] && !isHidden(layout.panelId[i])) {
                const auto [a, b, c] = layout.panelCorners[i];
                panels.push_back({first + a, first + b, first + c});
            }
        for (std::size_t i = 0; i < layout.links.size(); ++i)
            if (!frame.torn[i] && !isHidden(layout.links[i].id))
                links.push_back({first + layout.links[i].a, first + layout.links[i].b});
        panelColor.resize(panels.size(), color);
        linkColor.resize(links.size(), color);
        first += int(frame.position.size());
    }
    m_panels->SetPolys(cellsOf<3>(panels));
    m_links->SetLines(cellsOf<2>(links));
    std::ranges::copy(panelColor, m_panelColors.resized(panels.size()).begin());
    std::ranges::copy(linkColor, m_linkColors.resized(links.size()).begin());
    colorByCells(*m_panels, *m_panelActor->GetMapper(), m_panelColors);
    colorByCells(*m_links, *m_linkActor->GetMapper(), m_linkColors);
}

} // namespace ripstop
