// rebuild() says of which vertices of the panels those of the bands are mixed, and update() mixes
// what these have by now.
#include "layers/band_drawing.h"

#include <vtkRenderer.h>

namespace ripstop {
namespace {

constexpr float layersThrough = 0.5F; // of the light that comes through one layer

template <std::size_t Size>
std::array<float, Size> mixed(std::span<const std::array<float, Size>> values,
                              const Corners& vertices, const std::array<float, 3>& shares)
{
    std::array<float, Size> sum{};
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t i = 0; i < Size; ++i)
            sum[i] += shares[corner] * values[vertices[corner]][i];
    return sum;
}

template <std::size_t Size>
std::array<float, Size>* rowsOf(vtkFloatArray& array, std::size_t count)
{
    array.SetNumberOfTuples(vtkIdType(count));
    array.Modified();
    return reinterpret_cast<std::array<float, Size>*>(array.GetPointer(0));
}

} // namespace

BandDrawing::BandDrawing(BandKind kind)
    : m_kind(kind)
{
    joinCloth(*m_mesh, *m_points, *m_normals, *m_onCloth, *m_shade);
    m_mapper->SetInputData(m_mesh);
    // before the panels that they lie on, seams before borders, both behind the links
    const double depth = kind == BandKind::Sewn ? 0.0 : 0.5;
    m_mapper->SetResolveCoincidentTopologyToPolygonOffset();
    m_mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(depth, 2.0 * depth);
    m_actor->SetMapper(m_mapper);
    addClothShader(*m_actor, *m_mapper);
}

void BandDrawing::addTo(vtkRenderer& renderer) { renderer.AddActor(m_actor); }

void BandDrawing::setShown(bool shown) { m_actor->SetVisibility(shown); }

void BandDrawing::rebuild(const std::vector<BandPiece>& pieces, const ClothVertices& vertices,
                          std::span<const std::uint8_t> present)
{
    m_mixtures.clear();
    std::vector<ClothPoint> onCloth;
    std::vector<Color> colors;
    vtkNew<vtkCellArray> cells;
    for (const BandPiece& piece : pieces) {
        if (piece.kind != m_kind || !present[piece.panel])
            continue;
        cells->InsertNextCell(int(piece.corners.size()));
        for (const auto& shares : piece.corners) {
            cells->InsertCellPoint(vtkIdType(m_mixtures.size()));
            const Corners& panel = vertices.corners[piece.panel];
            m_mixtures.push_back({panel, shares});
            onCloth.push_back(mixed<4>(vertices.point, panel, shares));
            onCloth.back()[2] *= m_kind == BandKind::Sewn ? layersThrough : 1.0F;
        }
        colors.push_back(piece.color);
    }
    m_mesh->SetPolys(cells);
    m_points->SetNumberOfPoints(vtkIdType(m_mixtures.size()));
    std::ranges::copy(onCloth, rowsOf<4>(*m_onCloth, onCloth.size()));
    std::ranges::copy(colors, m_colors.resized(colors.size()).begin());
    colorByCells(*m_mesh, *m_mapper, m_colors);
}

void BandDrawing::update(std::span<const std::array<float, 3>> points,
                         std::span<const std::array<float, 3>> normals,
                         std::span<const Shades> shade)
{
    auto* point = reinterpret_cast<std::array<float, 3>*>(m_points->GetVoidPointer(0));
    auto* normal = rowsOf<3>(*m_normals, m_mixtures.size());
    Shades* shadeHere = rowsOf<3>(*m_shade, m_mixtures.size());
    for (const auto& [vertices, shares] : m_mixtures) {
        *point++ = mixed<3>(points, vertices, shares);
        *normal++ = mixed<3>(normals, vertices, shares);
        *shadeHere++ = mixed<3>(shade, vertices, shares);
    }
    m_points->Modified();
    m_mesh->Modified();
}

} // namespace ripstop
