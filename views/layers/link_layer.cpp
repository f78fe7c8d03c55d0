// rebuild() collects the links of each kind that are shown and not torn, and chooses the width of
// the lines. update() takes the points of the picture and paints: in one neutral colour where the
// quantity belongs to panels, by points where it belongs to particles (speed), and by cells where
// it belongs to links or where the colours are those of the materials.
#include "layers/link_layer.h"

#include "look/line_color.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr std::array width{1.3, 2.4}; // pixels, by LinkKind

// Dense fabric would drown in thick lines.
constexpr std::size_t manyLinks = 3000;

// The authors' colours, made to be seen. Neighbours in the table mostly have the same colour, so
// the last answer is kept.
class SeenColors
{
public:
    explicit SeenColors(const Theme& theme)
        : m_theme(theme)
    {}

    const Color& of(const Color& authored)
    {
        if (m_isFirst || authored != m_authored) {
            m_authored = authored;
            m_seen = lineColor(authored, m_theme);
            m_isFirst = false;
        }
        return m_seen;
    }

private:
    const Theme& m_theme;
    Color m_authored{};
    Color m_seen{};
    bool m_isFirst = true;
};

} // namespace

LinkLayer::LinkLayer()
{
    for (Lines& lines : m_lines) {
        lines.mapper->SetInputData(lines.data);
        lines.mapper->SetResolveCoincidentTopologyToPolygonOffset();
        lines.mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -2.0);
        lines.actor->SetMapper(lines.mapper);
        lines.actor->GetProperty()->LightingOff();
    }
}

void LinkLayer::addTo(vtkRenderer& renderer)
{
    for (Lines& lines : m_lines)
        renderer.AddActor(lines.actor);
}

void LinkLayer::setShown(bool shown)
{
    for (Lines& lines : m_lines)
        lines.actor->SetVisibility(shown);
}

void LinkLayer::rebuild(const Picture& picture)
{
    const auto& links = picture.layout().links;
    for (int kind = 0; kind < 2; ++kind) {
        Lines& lines = m_lines[kind];
        lines.drawn.clear();
        std::vector<std::array<int, 2>> ends;
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (int(links[i].kind) != kind || picture.frame.torn[i] || !picture.look.linkShown[i])
                continue;
            lines.drawn.push_back(int(i));
            ends.push_back({links[i].a, links[i].b});
        }
        lines.data->SetLines(cellsOf<2>(ends));
        const bool thin = lines.drawn.size() > manyLinks;
        lines.actor->GetProperty()->SetLineWidth(
            float(picture.pixelRatio * (thin ? 1.0 : width[kind])));
    }
}

void LinkLayer::update(const Picture& picture)
{
    for (Lines& lines : m_lines) {
        lines.data->SetPoints(picture.points);
        paint(picture, lines);
        lines.data->Modified();
    }
}

void LinkLayer::paint(const Picture& picture, Lines& lines)
{
    const QuantityValues& values = picture.values;
    const bool isOfPanels = picture.colorBy == ColorBy::PanelLoad
                            || picture.colorBy == ColorBy::Wrinkles
                            || picture.colorBy == ColorBy::Grain;
    if (isOfPanels) {
        setColor(*lines.actor->GetProperty(), picture.theme.neutral);
        colorByProperty(*lines.data, *lines.mapper);
    } else if (picture.colorBy == ColorBy::Speed) {
        const std::span<Color> colors = lines.colors.resized(values.particle.size());
        for (std::size_t i = 0; i < colors.size(); ++i)
            colors[i] = picture.colorOf(values.particle[i]);
        colorByPoints(*lines.data, *lines.mapper, lines.colors);
    } else {
        const std::span<Color> colors = lines.colors.resized(lines.drawn.size());
        SeenColors seen(picture.theme);
        for (std::size_t i = 0; i < colors.size(); ++i)
            colors[i] = values.link.empty() ? seen.of(picture.look.linkColor[lines.drawn[i]])
                                            : picture.colorOf(values.link[lines.drawn[i]]);
        colorByCells(*lines.data, *lines.mapper, lines.colors);
    }
}

} // namespace ripstop
