// Bands of the fabric of one kind (look/bands.h), drawn by the panel layer on top of the panels:
// borders, and what is sewn on top of these.
//
// It has vertices of its own, each a mixture of those of one panel, and the same cloth as they.
#pragma once

#include "layers/cloth_shader.h"
#include "layers/vtk_data.h"
#include "look/bands.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>

class vtkRenderer;

namespace ripstop {

class BandDrawing
{
public:
    explicit BandDrawing(BandKind kind); // draws the pieces of this kind

    void addTo(vtkRenderer& renderer);
    void setShown(bool shown);
    vtkProperty& property() { return *m_actor->GetProperty(); }

    // The pieces on panels that are there. For numbers there are none, as bands have none.
    //     present  [panels]
    void rebuild(const std::vector<BandPiece>& pieces, const ClothVertices& vertices,
                 std::span<const std::uint8_t> present);

    // Points, normals and shade of the panels' vertices, as they are now.
    void update(std::span<const std::array<float, 3>> points,
                std::span<const std::array<float, 3>> normals, std::span<const Shades> shade);

private:
    struct Mixture
    {
        Corners vertices; // of the panel
        std::array<float, 3> shares;
    };

    BandKind m_kind;
    std::vector<Mixture> m_mixtures; // [vertices] here
    ColorArray m_colors;
    vtkNew<vtkPoints> m_points;
    vtkNew<vtkFloatArray> m_normals;
    vtkNew<vtkFloatArray> m_onCloth;
    vtkNew<vtkFloatArray> m_shade;
    vtkNew<vtkPolyData> m_mesh;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
