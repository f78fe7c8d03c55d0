// Many arrows in one colour, drawn as lines, for the layers of wind and vectors.
//
// An arrow is a shaft and four barbs, so that it reads from every side without a solid head. The
// owner clears the set, adds the arrows of the instant and finishes; arrows without a length or
// with one that is not finite are left out.
#pragma once

#include "base/vec3.h"

#include <QColor>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace ripstop {

class ArrowSet
{
public:
    ArrowSet();

    vtkActor& actor() { return *m_actor; }
    void style(const QColor& color, double pixelRatio);

    void clear();
    void add(const Vec3& tail, const Vec3& arrow); // m
    void finish();                                 // after the last one

private:
    void addStroke(const Vec3& from, const Vec3& to);

    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_lines;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
