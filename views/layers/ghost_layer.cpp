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
        mapper->ScalarVisibilityOff();
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
    const QColor& color = m_of == Of::Run ? run : design;
    setColor(*m_panelActor->GetProperty(), color);
    setColor(*m_linkActor->GetProperty(), color);

    std::vector<std::uint32_t> hidden;
    const Layout& layout = picture.layout();
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (!picture.look.linkShown[i])
            hidden.push_back(layout.links[i].id);
    for (std::size_t i = 0; i < layout.panelId.size(); ++i)
        if (!picture.look.panelShown[i])
            hidden.push_back(layout.panelId[i]);
    std::ranges::sort(hidden);
    if (std::exchange(m_hidden, std::move(hidden)) != m_hidden && m_frame)
        build();
}

void GhostLayer::show(std::shared_ptr<const Frame> frame)
{
    setShown(frame != nullptr);
    const bool same = m_frame && frame && m_frame->layout == frame->layout
                      && m_frame->torn == frame->torn && m_frame->gone == frame->gone;
    m_frame = std::move(frame);
    if (!m_frame)
        return;
    m_points->SetNumberOfPoints(vtkIdType(m_frame->position.size()));
    for (std::size_t i = 0; i < m_frame->position.size(); ++i)
        m_points->SetPoint(vtkIdType(i), m_frame->position[i].data());
    m_points->Modified();
    if (!same)
        build();
}

void GhostLayer::build()
{
    const Layout& layout = *m_frame->layout;
    const auto isHidden = [this](std::uint32_t id) {
        return std::ranges::binary_search(m_hidden, id);
    };
    std::vector<std::array<int, 3>> panels;
    for (std::size_t i = 0; i < layout.panelCorners.size(); ++i)
        if (!m_frame->gone[i] && !isHidden(layout.panelId[i]))
            panels.push_back(layout.panelCorners[i]);
    std::vector<std::array<int, 2>> links;
    for (std::size_t i = 0; i < layout.links.size(); ++i)
        if (!m_frame->torn[i] && !isHidden(layout.links[i].id))
            links.push_back({layout.links[i].a, layout.links[i].b});
    m_panels->SetPolys(cellsOf<3>(panels));
    m_links->SetLines(cellsOf<2>(links));
}

} // namespace ripstop
