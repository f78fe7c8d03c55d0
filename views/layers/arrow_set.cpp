#include "layers/arrow_set.h"

#include <Eigen/Geometry>
#include <vtkProperty.h>

#include <cmath>

namespace ripstop {
namespace {

constexpr double shaftWidth = 1.6; // pixels
constexpr double headShare = 0.2;  // of an arrow

} // namespace

ArrowSet::ArrowSet()
{
    m_points->SetDataTypeToDouble();
    m_data->SetPoints(m_points);
    m_data->SetLines(m_lines);
    m_mapper->SetInputData(m_data);
    m_mapper->ScalarVisibilityOff();
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->GetProperty()->SetOpacity(0.75);
}

void ArrowSet::style(const QColor& color, double pixelRatio)
{
    m_actor->GetProperty()->SetLineWidth(float(pixelRatio * shaftWidth));
    m_actor->GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
}

void ArrowSet::clear()
{
    m_points->Reset();
    m_lines->Reset();
}

void ArrowSet::addStroke(const Vec3& from, const Vec3& to)
{
    const vtkIdType ends[2] = {m_points->InsertNextPoint(from.data()),
                               m_points->InsertNextPoint(to.data())};
    m_lines->InsertNextCell(2, ends);
}

void ArrowSet::add(const Vec3& tail, const Vec3& arrow)
{
    const double length = arrow.norm();
    if (!(length > 0.0) || !std::isfinite(length))
        return;
    const Vec3 tip = tail + arrow;
    addStroke(tail, tip);
    const Vec3 hint = std::abs(arrow.y()) < 0.9 * length ? Vec3::UnitY() : Vec3::UnitX();
    const Vec3 side = arrow.cross(hint).normalized() * length;
    const Vec3 other = arrow.cross(side) / length;
    for (const Vec3& barb : {side, Vec3(-side), other, Vec3(-other)})
        addStroke(tip, tip - headShare * (arrow + 0.4 * barb));
}

void ArrowSet::finish()
{
    m_points->Modified();
    m_lines->Modified();
    m_data->Modified();
}

} // namespace ripstop
