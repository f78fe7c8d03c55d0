// Small helpers between our arrays and VTK's: colours, arrays of colours, and cells.
//
// Layers use them in rebuild() and update(), in the thread of the window. Each of the three
// colorBy...() functions takes away what another one has set, as VTK data keep their scalars.
#pragma once

#include "look/look.h"
#include "look/theme.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <span>

namespace ripstop {

inline void setColor(vtkProperty& property, const QColor& color)
{
    property.SetColor(color.redF(), color.greenF(), color.blueF());
}

inline Color toColor(const QColor& color)
{
    return {std::uint8_t(color.red()), std::uint8_t(color.green()), std::uint8_t(color.blue())};
}

// The colours of cells or points, kept between frames and only refilled.
class ColorArray
{
public:
    ColorArray() { m_array->SetNumberOfComponents(3); }

    std::span<Color> resized(std::size_t count)
    {
        m_array->SetNumberOfTuples(vtkIdType(count));
        m_array->Modified();
        return {reinterpret_cast<Color*>(m_array->GetPointer(0)), count};
    }
    vtkUnsignedCharArray* array() { return m_array; }

private:
    vtkNew<vtkUnsignedCharArray> m_array;
};

inline void colorByCells(vtkPolyData& data, vtkMapper& mapper, ColorArray& colors)
{
    data.GetPointData()->SetScalars(nullptr);
    data.GetCellData()->SetScalars(colors.array());
    mapper.SetScalarModeToUseCellData();
    mapper.ScalarVisibilityOn();
}

inline void colorByPoints(vtkPolyData& data, vtkMapper& mapper, ColorArray& colors)
{
    data.GetCellData()->SetScalars(nullptr);
    data.GetPointData()->SetScalars(colors.array());
    mapper.SetScalarModeToUsePointData();
    mapper.ScalarVisibilityOn();
}

inline void colorByProperty(vtkPolyData& data, vtkMapper& mapper)
{
    data.GetCellData()->SetScalars(nullptr);
    data.GetPointData()->SetScalars(nullptr);
    mapper.ScalarVisibilityOff();
}

// Cells of `Size` particles each, by the indices of their points.
template <std::size_t Size>
vtkNew<vtkCellArray> cellsOf(std::span<const std::array<int, Size>> list)
{
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(vtkIdType(list.size()), vtkIdType(Size * list.size()));
    for (const std::array<int, Size>& cell : list) {
        cells->InsertNextCell(int(Size));
        for (const int index : cell)
            cells->InsertCellPoint(index);
    }
    return cells;
}

} // namespace ripstop
