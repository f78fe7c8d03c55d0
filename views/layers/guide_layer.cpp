#include "layers/guide_layer.h"

#include <vtkPoints.h>
#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr double reach = 0.03;     // of the diagonal of what is shown, from the particle to an end
constexpr double stop = 0.25;      // of the reach, half of the stop at the end of a line
constexpr double square = 0.6;     // of the reach, half a side
constexpr double guideWidth = 2.5; // pixels

// Two unit directions across the axis and across each other.
std::pair<Vec3, Vec3> across(const Vec3& axis)
{
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    const Vec3 first = axis.cross(Vec3::Unit(least)).normalized();
    return {first, axis.cross(first)};
}

std::array<Vec3, 6> cornersOf(const GuidedParticle& guided, double size)
{
    const auto [u, v] = across(guided.axis);
    if (guided.guide == Guide::Line) {
        const Vec3 end = size * guided.axis, side = stop * size * u;
        return {-end, end, -end - side, -end + side, end - side, end + side};
    }
    const Vec3 a = square * size * u, b = square * size * v;
    return {a + b, a - b, -a - b, b - a, Vec3::Zero(), Vec3::Zero()};
}

using Stroke = std::array<int, 2>;
constexpr std::array<Stroke, 3> lineStrokes{{{0, 1}, {2, 3}, {4, 5}}};
constexpr std::array<Stroke, 4> planeStrokes{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};

} // namespace

GuideLayer::GuideLayer()
{
    m_data->SetPoints(m_points);
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -30.0);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
}

void GuideLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void GuideLayer::rebuild(const Picture& picture)
{
    const double size = picture.bounds.isEmpty() ? 0.1 : reach * picture.bounds.sizes().norm();
    m_marks.clear();
    std::vector<Stroke> strokes;
    for (const GuidedParticle& guided : picture.layout().guided) {
        if (!picture.look.particleShown[std::size_t(guided.particle)]
            || picture.layout().pinned[std::size_t(guided.particle)])
            continue;
        const int first = 6 * int(m_marks.size());
        const auto add = [&](const auto& some) {
            for (const Stroke& one : some)
                strokes.push_back({first + one[0], first + one[1]});
        };
        if (guided.guide == Guide::Line)
            add(lineStrokes);
        else
            add(planeStrokes);
        m_marks.push_back({guided.particle, cornersOf(guided, size)});
    }
    m_data->SetLines(cellsOf<2>(strokes));
    m_points->SetNumberOfPoints(vtkIdType(6 * m_marks.size()));
    m_actor->GetProperty()->SetLineWidth(float(picture.pixelRatio * guideWidth));
    setColor(*m_actor->GetProperty(), picture.theme.pin);
}

void GuideLayer::update(const Picture& picture)
{
    vtkIdType point = 0;
    for (const Mark& mark : m_marks)
        for (const Vec3& corner : mark.corners) {
            const Vec3 at = picture.frame.position[std::size_t(mark.particle)] + corner;
            m_points->SetPoint(point++, at.x(), at.y(), at.z());
        }
    m_points->Modified();
    m_data->Modified();
}

} // namespace ripstop
