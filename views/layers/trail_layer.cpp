#include "layers/trail_layer.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr double trailWidth = 2.5; // pixels

} // namespace

TrailLayer::TrailLayer()
{
    m_points->SetDataTypeToDouble();
    m_colors->SetNumberOfComponents(4);
    m_lines->SetPoints(m_points);
    m_lines->GetPointData()->SetScalars(m_colors);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(m_lines);
    mapper->SetScalarModeToUsePointData();
    m_actor->SetMapper(mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->ForceTranslucentOn();
    m_actor->PickableOff();
    m_actor->VisibilityOff();
}

void TrailLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void TrailLayer::setShown(bool shown)
{
    m_shown = shown;
    m_trails.clear();
    m_actor->SetVisibility(shown);
}

void TrailLayer::rebuild(const Picture& picture)
{
    m_actor->GetProperty()->SetLineWidth(float(trailWidth * picture.pixelRatio));
}

void TrailLayer::update(const Picture& picture)
{
    if (!m_shown)
        return;
    m_trails.follow(trailed(picture.scene, picture.selected));
    m_trails.add(picture.frame);
    draw(picture.theme);
}

void TrailLayer::draw(const Theme& theme)
{
    const Color color = theme.isDark() ? Color{0xff, 0xd1, 0x66} : Color{0xb3, 0x47, 0x00};
    m_points->Reset();
    m_colors->Reset();
    vtkNew<vtkCellArray> cells;
    const auto& points = m_trails.points();
    const double now = points.empty() ? 0.0 : points.back().time;
    for (std::size_t i = 0; i < m_trails.followed().size(); ++i) {
        bool goesOn = false;
        for (const Trails::Point& point : points) {
            const Vec3& place = point.place[i];
            if (!place.allFinite()) {
                goesOn = false;
                continue;
            }
            const double age = (now - point.time) / Trails::length;
            const vtkIdType id = m_points->InsertNextPoint(place.data());
            m_colors->InsertNextTuple4(color[0], color[1], color[2], 255.0 * (1.0 - age));
            if (goesOn) {
                cells->InsertNextCell(2);
                cells->InsertCellPoint(id - 1);
                cells->InsertCellPoint(id);
            }
            goesOn = true;
        }
    }
    m_lines->SetLines(cells);
    m_points->Modified();
    m_colors->Modified();
}

} // namespace ripstop
