// Another run at the same time, or the design, as a pale shape that one sees through.
//
// It has a layout of its own and its own copy of the points, unlike the other layers, which share
// those of the picture. Links and panels that are hidden in the picture are hidden in it, found by
// their ids. Its frame comes by show() and not with the picture.
#pragma once

#include "layers/layer.h"
#include "layers/vtk_data.h"

#include <vtkActor.h>
#include <vtkPoints.h>

#include <memory>

namespace ripstop {

class GhostLayer final : public Layer
{
public:
    enum class Of { Run, Design };
    explicit GhostLayer(Of of);

    void show(std::shared_ptr<const Frame> frame); // null shows nothing

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture&) override {}

private:
    void build();

    Of m_of;
    std::shared_ptr<const Frame> m_frame; // whose network is drawn
    std::vector<std::uint32_t> m_hidden;  // links and panels, ascending
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkPolyData> m_panels;
    vtkNew<vtkPolyData> m_links;
    vtkNew<vtkActor> m_panelActor;
    vtkNew<vtkActor> m_linkActor;
};

} // namespace ripstop
