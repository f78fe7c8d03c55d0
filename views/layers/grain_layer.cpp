// rebuild() chooses the panels that have a stroke and the pens; update() puts the strokes where the
// warp runs now. They are drawn twice from the same points, wide in white and then thin in black,
// as fabric has all colours in every theme.
#include "layers/grain_layer.h"

#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t mostStrokes = 20000;
constexpr double strokeReach = 0.3;     // of the root of twice the area of a panel, either way
constexpr double inkWidth = 1.6;        // pixels
constexpr double edgeWidth = 3.4;       // pixels
constexpr double beforePanels = -100.0; // enough for wide strokes on fabric that is seen on edge

} // namespace

std::array<Vec3, 2> grainStroke(const Look::Warp& warp, const std::array<Vec3, 3>& corners)
{
    const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec3 way = (warp.shares[0] * ab + warp.shares[1] * ac).normalized();
    const Vec3 half = strokeReach * std::sqrt(ab.cross(ac).norm()) * way;
    return {middle - half, middle + half};
}

GrainLayer::GrainLayer()
{
    m_points->SetDataTypeToDouble();
    m_data->SetPoints(m_points);
    double offset = beforePanels;
    for (Pen* pen : {&m_edge, &m_ink}) {
        pen->mapper->SetInputData(m_data);
        pen->mapper->ScalarVisibilityOff();
        pen->mapper->SetResolveCoincidentTopologyToPolygonOffset();
        pen->mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, offset);
        pen->actor->SetMapper(pen->mapper);
        pen->actor->GetProperty()->LightingOff();
        pen->actor->PickableOff();
        pen->actor->VisibilityOff();
        offset *= 2.0;
    }
}

void GrainLayer::addTo(vtkRenderer& renderer)
{
    renderer.AddActor(m_edge.actor);
    renderer.AddActor(m_ink.actor);
}

void GrainLayer::setShown(bool shown)
{
    m_shown = shown;
    m_edge.actor->SetVisibility(shown);
    m_ink.actor->SetVisibility(shown);
}

void GrainLayer::rebuild(const Picture& picture)
{
    m_panels.clear();
    if (!m_shown)
        return;
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < picture.look.panelWarp.size(); ++i)
        if (picture.look.panelWarp[i].isThere && picture.look.panelShown[i]
            && !picture.frame.gone[i])
            all.push_back(i);
    for (std::size_t i = 0; i < all.size(); i += all.size() / mostStrokes + 1)
        m_panels.push_back(all[i]);
    std::vector<std::array<int, 2>> strokes;
    for (int i = 0; i < int(m_panels.size()); ++i)
        strokes.push_back({2 * i, 2 * i + 1});
    m_data->SetLines(cellsOf<2>(strokes));
    m_points->SetNumberOfPoints(vtkIdType(2 * m_panels.size()));
    const auto style = [&](Pen& pen, double width, const QColor& color) {
        pen.actor->GetProperty()->SetLineWidth(float(picture.pixelRatio * width));
        setColor(*pen.actor->GetProperty(), color);
    };
    style(m_edge, edgeWidth, QColor(Qt::white));
    style(m_ink, inkWidth, QColor(Qt::black));
}

void GrainLayer::update(const Picture& picture)
{
    vtkIdType point = 0;
    for (const std::size_t panel : m_panels) {
        const auto [a, b, c] = picture.layout().panelCorners[panel];
        const auto at = [&](int corner) -> Vec3 {
            return picture.frame.position[std::size_t(corner)];
        };
        for (const Vec3& end : grainStroke(picture.look.panelWarp[panel], {at(a), at(b), at(c)}))
            m_points->SetPoint(point++, end.x(), end.y(), end.z());
    }
    m_points->Modified();
    m_data->Modified();
}

} // namespace ripstop
