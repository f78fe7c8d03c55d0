// Links: those of a known thickness as tubes, others as lines, springs thin and rods thick; torn
// links are gone.
//
// There is one set of lines for each kind of link, as a line width belongs to an actor. Links have
// the author's colour, made to be seen before the sky, or the colour of the quantity that the view
// shows. Those that stand for fabric are not drawn on it unless the mesh is asked for, or links
// show a quantity. Dense fabric gets thin lines throughout.
#pragma once

#include "layers/layer.h"
#include "layers/tube_set.h"
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
    bool isDrawn(const Picture& picture, std::size_t link) const;
    void findFabric(const Picture& picture);
    static void paint(const Picture& picture, Lines& lines);
    void paintTubes(const Picture& picture);

    std::shared_ptr<const Layout> m_layout;
    std::vector<std::uint8_t> m_onFabric; // [particles] with a panel
    std::vector<int> m_tubed;             // index of the link of each tube
    TubeSet m_tubes;
    std::array<Lines, 2> m_lines; // by LinkKind
};

} // namespace ripstop
