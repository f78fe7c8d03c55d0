#include "layers/streak_layer.h"

#include "scene/wind.h"

#include <vtkRenderer.h>

#include <cmath>

namespace ripstop {
namespace {

constexpr double strokeWidth = 1.8;  // pixels
constexpr double mostOpacity = 0.55; // of a head

} // namespace

StreakLayer::StreakLayer()
{
    m_points->SetDataTypeToDouble();
    m_colors->SetNumberOfComponents(4);
    m_data->SetPoints(m_points);
    m_data->SetLines(m_lines);
    m_data->GetPointData()->SetScalars(m_colors);
    m_mapper->SetInputData(m_data);
    m_actor->SetMapper(m_mapper);
    m_actor->ForceOpaqueOn(); // blended as it comes, as shadows are (backdrop_layer.cpp)
    m_actor->GetProperty()->LightingOff();
}

void StreakLayer::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void StreakLayer::setShown(bool shown)
{
    m_shown = shown;
    m_actor->SetVisibility(shown);
}

void StreakLayer::rebuild(const Picture& picture)
{
    m_color = picture.theme.wind;
    m_actor->GetProperty()->SetLineWidth(float(strokeWidth * picture.pixelRatio));
}

void StreakLayer::update(const Picture& picture)
{
    m_winds.clear();
    for (const Entry& entry : picture.scene.items)
        if (const Wind* wind = std::get_if<Wind>(&entry.item))
            if (const Airflow flow = airflowOf(*wind); flow.velocity.norm() > 0.0)
                m_winds.push_back(flow);
    m_gust = picture.frame.gust;
    m_time = picture.frame.time;
}

void StreakLayer::place(const StreakView& view)
{
    if (!m_shown)
        return;
    m_points->Reset();
    m_lines->Reset();
    m_colors->Reset();
    for (const WindStreak& streak : windStreaks(m_winds, m_gust, m_time, view))
        add(streak);
    m_points->Modified();
    m_lines->Modified();
    m_colors->Modified();
    m_data->Modified();
}

void StreakLayer::add(const WindStreak& streak)
{
    m_lines->InsertNextCell(WindStreak::points);
    for (int i = 0; i < WindStreak::points; ++i) {
        const double along = double(i) / (WindStreak::points - 1); // 0 at the tail
        const std::array<std::uint8_t, 4> color{
            std::uint8_t(m_color.red()), std::uint8_t(m_color.green()),
            std::uint8_t(m_color.blue()),
            std::uint8_t(std::lround(255.0 * mostOpacity * streak.opacity * along))};
        m_lines->InsertCellPoint(m_points->InsertNextPoint(streak.path[std::size_t(i)].data()));
        m_colors->InsertNextTypedTuple(color.data());
    }
}

} // namespace ripstop
