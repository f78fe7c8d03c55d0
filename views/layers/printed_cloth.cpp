#include "layers/printed_cloth.h"

#include "layers/cloth_shader.h"

#include <QImage>
#include <QPainter>
#include <vtkImageData.h>
#include <vtkPoints.h>

namespace ripstop {
namespace {

constexpr int largest = 2048; // pixels, of a side

// As VTK has it, from the lowest row up, three bytes a pixel.
vtkNew<vtkImageData> imageOf(const QImage& picture)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width(), picture.height(), 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int row = picture.height() - 1; row >= 0; --row)
        pixel = std::copy_n(picture.constScanLine(row), 3 * picture.width(), pixel);
    return image;
}

} // namespace

PrintedCloth::PrintedCloth(vtkPolyData& vertices)
{
    m_places->SetNumberOfComponents(2);
    m_mesh->SetPoints(vertices.GetPoints());
    m_mesh->GetPointData()->SetNormals(vertices.GetPointData()->GetNormals());
    for (const char* array : {clothPointArray, shadeArray})
        m_mesh->GetPointData()->AddArray(vertices.GetPointData()->GetArray(array));
    m_mesh->GetPointData()->SetTCoords(m_places);
    m_mapper->SetInputData(m_mesh);
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.75, 1.5);
    m_mapper->ScalarVisibilityOff(); // white, which the picture colours
    m_actor->SetMapper(m_mapper);
    m_actor->SetTexture(m_texture);
    m_texture->RepeatOn();
    m_texture->MipmapOn();
    m_texture->InterpolateOn();
    // llvmpipe of Mesa 22 walks over every texel below a pixel, of which there is no end where a
    // panel is seen on edge: one picture could take minutes
    m_texture->SetMaximumAnisotropicFiltering(1.0F);
    addClothShader(*m_actor, *m_mapper);
}

void PrintedCloth::rebuild(const Look::Print& print, const ClothVertices& vertices,
                           std::span<const Corners> corners)
{
    m_mesh->SetPolys(cellsOf<3>(corners));
    m_actor->SetVisibility(!corners.empty()); // the stage leaves out what is empty, but no parts
    if (corners.empty())
        return;
    load(print);
    m_places->SetNumberOfTuples(vtkIdType(vertices.particle.size()));
    auto* place = reinterpret_cast<std::array<float, 2>*>(m_places->GetPointer(0));
    for (const int particle : vertices.particle)
        *place++ = print.at[particle];
    m_places->Modified();
}

void PrintedCloth::load(const Look::Print& print)
{
    std::error_code error;
    const auto written = std::filesystem::last_write_time(print.file, error);
    if (print.file == m_file && print.ground == m_ground && written == m_written)
        return;
    m_file = print.file;
    m_ground = print.ground;
    m_written = written;
    const QImage read(QString::fromStdString(print.file));
    const QSize size = read.size().boundedTo({largest, largest});
    QImage picture(size.isEmpty() ? QSize(1, 1) : size, QImage::Format_RGB888);
    picture.fill(QColor(print.ground[0], print.ground[1], print.ground[2]));
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(picture.rect(), read);
    painter.end();
    m_texture->SetInputData(imageOf(picture));
}

} // namespace ripstop
