// Round things of a thickness, at any distance: lines and spars.
//
// Each is a strip that turns its flat side to the eye, as wide as the thing is thick but never
// narrower than a pixel and a half, and shaded as if it were round: a sharp picture for two
// triangles each. The program for the graphics card makes the strips, so a frame brings the ends
// only.
#pragma once

#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>

class vtkRenderer;

namespace ripstop {

class TubeSet
{
public:
    struct Tube
    {
        int a; // particle indices
        int b;
        double thickness; // m
    };

    // With a border, in pixels on either side, it is the halo of such things: it lies behind them,
    // so that they keep their colour inside of it.
    explicit TubeSet(double border = 0.0);

    void addTo(vtkRenderer& renderer);
    void setShown(bool shown) { m_actor->SetVisibility(shown); }
    void rebuild(const std::vector<Tube>& tubes, double pixelRatio);
    void update(std::span<const Vec3> position);

    // Shaded, or in plain colours that stand for numbers.
    void setShaded(bool shaded);
    void setColor(const QColor& color);
    template <typename ColorOf>
    void paint(ColorOf colorOf) // of an end of a tube: (index of the tube, particle)
    {
        const std::span<Color> colors = m_colors.resized(4 * m_tubes.size());
        for (std::size_t i = 0; i < m_tubes.size(); ++i) {
            const Color a = colorOf(i, m_tubes[i].a), b = colorOf(i, m_tubes[i].b);
            std::ranges::copy(std::array{a, a, b, b}, colors.begin() + std::ptrdiff_t(4 * i));
        }
        colorByPoints(*m_mesh, *m_mapper, m_colors);
    }

private:
    void takeHeight(vtkObject* renderer, unsigned long, void*);

    double m_border; // pixels
    std::vector<Tube> m_tubes;
    ColorArray m_colors;
    vtkNew<vtkPoints> m_points;     // [tubes][4] anywhere
    vtkNew<vtkFloatArray> m_ends;   // [tubes][4] m: twice a, twice b
    vtkNew<vtkFloatArray> m_others; // [tubes][4] m, the other end
    vtkNew<vtkFloatArray> m_sides;  // [tubes][4] which side of the strip, and the radius in m
    vtkNew<vtkPolyData> m_mesh;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
