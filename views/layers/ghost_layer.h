// Other runs at the same time, or the design, as pale shapes that one sees through.
//
// It has a layout of its own and its own copy of the points, unlike the other layers, which share
// those of the picture. Links and panels that are hidden in the picture are hidden in it, found by
// their ids. Its frames come by show() and not with the picture.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkPoints.h>

#include <QColor>

#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

class GhostLayer final : public Layer
{
public:
    enum class Of { Run, Design };
    explicit GhostLayer(Of of);

    struct Ghost
    {
        std::shared_ptr<const Frame> frame; // null shows nothing
        std::optional<QRgb> color = {};     // none: that of the layer
    };
    void show(std::vector<Ghost> ghosts);

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture&) override {}

private:
    void build();

    Of m_of;
    std::vector<Ghost> m_ghosts;         // whose networks are drawn
    std::vector<std::uint32_t> m_hidden; // links and panels, ascending
    vtkNew<vtkPoints> m_points;
    QColor m_color; // of those without one
    ColorArray m_panelColors;
    ColorArray m_linkColors;
    vtkNew<vtkPolyData> m_panels;
    vtkNew<vtkPolyData> m_links;
    vtkNew<vtkActor> m_panelActor;
    vtkNew<vtkActor> m_linkActor;
};

} // namespace ripstop
