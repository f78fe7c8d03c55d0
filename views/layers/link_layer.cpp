// rebuild() collects the links of each kind that are shown and not torn, and what is round apart,
// and chooses the width of the lines. update() takes the points of the picture and paints: in one
// neutral colour where the quantity belongs to panels, by points where it belongs to particles
// (speed), and by cells where it belongs to links or where the colours are those of the materials.
#include "layers/link_layer.h"

#include "look/line_color.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr std::array width{1.3, 2.4}; // pixels, by LinkKind

// Dense fabric would drown in thick lines.
constexpr std::size_t manyLinks = 3000;

bool isOfPanels(ColorBy colorBy)
{
    return colorBy == ColorBy::PanelLoad || colorBy == ColorBy::Wrinkles
           || colorBy == ColorBy::Grain;
}

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
    m_tubes.addTo(renderer);
}

void LinkLayer::setShown(bool shown)
{
    for (Lines& lines : m_lines)
        lines.actor->SetVisibility(shown);
    m_tubes.setShown(shown);
}

void LinkLayer::findFabric(const Picture& picture)
{
    if (m_layout == picture.frame.layout)
        return;
    m_layout = picture.frame.layout;
    m_onFabric.assign(m_layout->particleId.size(), 0);
    for (const auto& corners : m_layout->panelCorners)
        for (const int corner : corners)
            m_onFabric[corner] = 1;
}

bool LinkLayer::isDrawn(const Picture& picture, std::size_t link) const
{
    if (picture.frame.torn[link] || !picture.look.linkShown[link])
        return false;
    const Layout::Link& row = m_layout->links[link];
    const bool isMesh =
        picture.look.linkForm[link] == Look::Form::Wire && m_onFabric[row.a] && m_onFabric[row.b];
    return !isMesh || picture.isMeshShown || !picture.values.link.empty();
}

void LinkLayer::rebuild(const Picture& picture)
{
    findFabric(picture);
    const auto& links = picture.layout().links;
    std::array<std::vector<std::array<int, 2>>, 2> ends;
    std::vector<TubeSet::Tube> tubes;
    m_tubed.clear();
    for (Lines& lines : m_lines)
        lines.drawn.clear();
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (!isDrawn(picture, i))
            continue;
        if (const double thickness = picture.look.linkThickness[i]; thickness > 0.0) {
            tubes.push_back({links[i].a, links[i].b, thickness});
            m_tubed.push_back(int(i));
        } else {
            m_lines[int(links[i].kind)].drawn.push_back(int(i));
            ends[int(links[i].kind)].push_back({links[i].a, links[i].b});
        }
    }
    m_tubes.rebuild(tubes, picture.pixelRatio);
    for (int kind = 0; kind < 2; ++kind) {
        Lines& lines = m_lines[kind];
        lines.data->SetLines(cellsOf<2>(ends[kind]));
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
    m_tubes.update(picture.frame.position);
    paintTubes(picture);
}

void LinkLayer::paint(const Picture& picture, Lines& lines)
{
    const QuantityValues& values = picture.values;
    if (isOfPanels(picture.colorBy)) {
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

void LinkLayer::paintTubes(const Picture& picture)
{
    const QuantityValues& values = picture.values;
    m_tubes.setShaded(picture.colorBy == ColorBy::Material);
    SeenColors seen(picture.theme);
    if (isOfPanels(picture.colorBy))
        m_tubes.setColor(picture.theme.neutral);
    else if (picture.colorBy == ColorBy::Speed)
        m_tubes.paint(
            [&](std::size_t, int particle) { return picture.colorOf(values.particle[particle]); });
    else if (values.link.empty())
        m_tubes.paint(
            [&](std::size_t tube, int) { return seen.of(picture.look.linkColor[m_tubed[tube]]); });
    else
        m_tubes.paint(
            [&](std::size_t tube, int) { return picture.colorOf(values.link[m_tubed[tube]]); });
}

} // namespace ripstop
