// Links as lines: springs thin, rods thick; torn links are gone.
//
// There is one set of lines for each kind of link, as a line width belongs to an actor. Lines have
// the author's colour, made to be seen before the sky, or the colour of the quantity that the view
// shows. Dense fabric gets thin lines throughout.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>

#include <array>

namespace ripstop {

class LinkLayer final : public Layer
{
public:
    LinkLayer();

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    struct Lines // of one kind
    {
        std::vector<int> drawn; // [cells] index of the link
        ColorArray colors;
        vtkNew<vtkPolyData> data;
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
    };
    static void paint(const Picture& picture, Lines& lines);

    std::array<Lines, 2> m_lines; // by LinkKind
};

} // namespace ripstop
