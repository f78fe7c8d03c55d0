// The wind as short streaks that drift with it and fade towards their tails (look/wind_streaks.h).
//
// update() notes the winds of the scene and the moment; place() draws the streaks about what the
// camera looks at, as it changes with every picture.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"
#include "look/wind_streaks.h"

#include <vtkActor.h>

namespace ripstop {

class StreakLayer final : public Layer
{
public:
    StreakLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

    void place(const StreakView& view); // before each picture

private:
    void add(const WindStreak& streak);

    std::vector<Airflow> m_winds;
    Vec3 m_gust = Vec3::Zero(); // m/s
    double m_time = 0.0;        // s
    QColor m_color;
    bool m_shown = true;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_lines;
    vtkNew<vtkUnsignedCharArray> m_colors;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
