#include "viewport/wind_layer.h"

#include "scene/wind.h"
#include "viewport/steady_range.h"

#include <Eigen/Geometry>
#include <vtkRenderer.h>

#include <cmath>

namespace ripstop {
namespace {

constexpr int arrowsAcross = 2;   // to either side of the middle
constexpr double lineWidth = 1.6; // pixels
constexpr double longest = 0.85;  // of the step between arrows
constexpr double headShare = 0.2; // of an arrow

// Steps of the grid, m: some for the size of what is shown.
double stepOf(const Eigen::AlignedBox3d& bounds)
{
    const double size = bounds.isEmpty() ? 1.0 : std::max(bounds.diagonal().norm(), 0.2);
    return roundedUp(0.35 * size);
}

void addStroke(const Vec3& from, const Vec3& to, vtkPoints& points, vtkCellArray& lines)
{
    const vtkIdType ends[2] = {points.InsertNextPoint(from.data()),
                               points.InsertNextPoint(to.data())};
    lines.InsertNextCell(2, ends);
}

void addArrow(const Vec3& middle, const Vec3& arrow, vtkPoints& points, vtkCellArray& lines)
{
    const Vec3 tip = middle + 0.5 * arrow;
    addStroke(middle - 0.5 * arrow, tip, points, lines);
    const Vec3 hint = std::abs(arrow.y()) < 0.9 * arrow.norm() ? Vec3::UnitY() : Vec3::UnitX();
    const Vec3 side = arrow.cross(hint).normalized() * arrow.norm();
    const Vec3 other = arrow.cross(side) / arrow.norm();
    for (const Vec3& barb : {side, Vec3(-side), other, Vec3(-other)})
        addStroke(tip, tip - headShare * (arrow + 0.4 * barb), points, lines);
}

} // namespace

std::vector<WindArrow> windField(const Scene& scene, const Vec3& gust,
                                 const Eigen::AlignedBox3d& bounds)
{
    const double step = stepOf(bounds);
    const Vec3 middle = bounds.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(bounds.center());
    const auto nearest = [&](int axis) { return std::round(middle[axis] / step); };
    std::vector<WindArrow> arrows;
    for (int i = -arrowsAcross; i <= arrowsAcross; ++i)
        for (int j = -arrowsAcross; j <= arrowsAcross; ++j)
            for (int k = -arrowsAcross; k <= arrowsAcross; ++k) {
                const Vec3 place =
                    step * Vec3(nearest(0) + i, nearest(1) + j + 0.5, nearest(2) + k);
                const Vec3 velocity = meanWindAt(scene, place) + gust;
                if (place.y() > 0.0 && velocity.norm() > 1e-3)
                    arrows.push_back({place, velocity});
            }
    return arrows;
}

WindLayer::WindLayer()
{
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->GetProperty()->SetOpacity(0.75);
    m_actor->SetVisibility(false);
}

void WindLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void WindLayer::setShown(bool shown)
{
    m_shown = shown;
    m_actor->SetVisibility(shown);
}

void WindLayer::rebuild(const Picture& picture)
{
    m_actor->GetProperty()->SetLineWidth(float(picture.pixelRatio * lineWidth));
    setColor(*m_actor->GetProperty(), picture.theme.wind);
}

void WindLayer::update(const Picture& picture)
{
    if (!m_shown)
        return;
    const auto arrows = windField(picture.scene, picture.frame.gust, picture.bounds);
    double fastest = 0.0;
    for (const WindArrow& arrow : arrows)
        fastest = std::max(fastest, arrow.velocity.norm());
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    points->SetDataTypeToDouble();
    for (const WindArrow& arrow : arrows)
        addArrow(arrow.place, longest * stepOf(picture.bounds) / fastest * arrow.velocity, *points,
                 *lines);
    m_data->SetPoints(points);
    m_data->SetLines(lines);
}

} // namespace ripstop
