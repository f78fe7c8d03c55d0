// The picture on the panels that have it, drawn by the panel layer on top of them.
//
// The vertices are those of the panels; the picture and its places on them are its own. Where the
// picture lets through, the colour of the material shows.
#pragma once

#include "layers/vtk_data.h"
#include "look/fabric.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkTexture.h>

#include <filesystem>

namespace ripstop {

class PrintedCloth
{
public:
    // Draws vertices of this mesh.
    explicit PrintedCloth(vtkPolyData& vertices);

    vtkActor& actor() { return *m_actor.Get(); }

    // On these panels, by the vertices of their corners.
    void rebuild(const Look::Print& print, const ClothVertices& vertices,
                 std::span<const Corners> corners);
    void moved() { m_mesh->Modified(); }

private:
    void load(const Look::Print& print);

    std::string m_file;
    Color m_ground{};
    std::filesystem::file_time_type m_written;
    vtkNew<vtkFloatArray> m_places;
    vtkNew<vtkTexture> m_texture;
    vtkNew<vtkPolyData> m_mesh;
    vtkNew<vtkPolyDataMapper> m_mapper;
    vtkNew<vtkActor> m_actor;
};

} // namespace ripstop
