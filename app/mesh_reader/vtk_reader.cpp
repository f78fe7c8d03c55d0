// The file is read by the reader of its kind; what VTK says of errors is kept and becomes the
// reason of a refusal. Collector copies points, arrays and cells, and believes no index in them.
#include "mesh_reader/vtk_reader.h"

#include "base/lower_case.h"

#include <filesystem>

#ifdef RIPSTOP_HAS_VTK

#include "mesh_reader/process_limits.h"
#include "shapes/mesh_process.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace ripstop {
namespace {

constexpr double shareOfFile = 0.7;         // of the progress, the rest is copying
constexpr std::size_t mostMaterials = 1000; // more are no materials but numbers of cells
constexpr std::size_t longestReason = 300;  // letters

// The first thing that VTK complains of; it prints nothing.
class Complaints final : public vtkOutputWindow
{
public:
    static Complaints* New() { return new Complaints; }

    void DisplayText(const char* text) override
    {
        if (m_first.empty() && text)
            m_first = text;
    }

    // "ERROR: In vtkXMLReader.cxx, line 1\nvtkXMLReader (0x1): Error parsing ...\n\n" without what
    // is of VTK's own source.
    std::string first() const
    {
        std::string text = m_first;
        if (const auto object = text.find("): "); object != std::string::npos)
            text.erase(0, object + 3);
        std::ranges::replace(text, '\n', ' ');
        text.erase(text.find_last_not_of(' ') + 1);
        return text.substr(0, longestReason);
    }

private:
    std::string m_first;
};

// Lower case, without the unit: "Mass (kg)" is "mass".
std::string plainName(const char* name)
{
    std::string plain = name ? name : "";
    plain.erase(std::min(plain.find(" ("), plain.size()));
    return lowerCase(std::move(plain));
}

vtkDataArray* arrayCalled(vtkFieldData& data, std::initializer_list<const char*> names,
                          int components)
{
    for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
        vtkDataArray* array = vtkArrayDownCast<vtkDataArray>(data.GetAbstractArray(i));
        if (!array || array->GetNumberOfComponents() < components)
            continue;
        const std::string plain = plainName(array->GetName());
        if (std::ranges::find(names, plain) != names.end())
            return array;
    }
    return nullptr;
}

class Collector
{
public:
    explicit Collector(vtkPointSet& data)
        : m_data(data)
    {}

    // False when a cell names a point that is not there.
    bool collect()
    {
        m_mesh.objects.emplace_back();
        const vtkIdType count = m_data.GetNumberOfPoints();
        for (vtkIdType i = 0; i < count; ++i)
            m_mesh.points.emplace_back(Eigen::Map<const Vec3>(m_data.GetPoint(i)));
        vtkDataArray* texture = m_data.GetPointData()->GetTCoords();
        m_texture = texture && texture->GetNumberOfComponents() >= 2
                        ? texture
                        : arrayCalled(*m_data.GetPointData(),
                                      {"texturecoordinates", "texcoords", "tcoords", "uv"}, 2);
        readMasses();
        m_materials =
            arrayCalled(*m_data.GetCellData(), {"material", "materialid", "materialids"}, 1);
        m_isCorner.resize(std::size_t(count));
        if (!takeCells())
            return false;
        keepLines();
        if (m_mesh.materials.empty())
            m_mesh.materials.emplace_back();
        return true;
    }

    PolygonMesh& mesh() { return m_mesh; }
    const std::string& trouble() const { return m_trouble; }

private:
    void readMasses()
    {
        vtkDataArray* mass = arrayCalled(*m_data.GetPointData(), {"mass", "masses"}, 1);
        if (!mass || mass->GetNumberOfTuples() < m_data.GetNumberOfPoints())
            return;
        for (vtkIdType i = 0; i < m_data.GetNumberOfPoints(); ++i) {
            const double value = mass->GetComponent(i, 0);
            m_mesh.mass.push_back(std::isfinite(value) && value > 0.0 ? value : 0.0);
        }
    }

    bool takeCells()
    {
        vtkNew<vtkIdList> ids;
        for (vtkIdType cell = 0; cell < m_data.GetNumberOfCells(); ++cell) {
            m_data.GetCellPoints(cell, ids);
            std::vector<int> points;
            for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
                const vtkIdType point = ids->GetId(i);
                if (point < 0 || point >= m_data.GetNumberOfPoints()) {
                    m_trouble = "cell " + std::to_string(cell) + " has point "
                                + std::to_string(point) + " of "
                                + std::to_string(m_data.GetNumberOfPoints());
                    return false;
                }
                points.push_back(int(point));
            }
            takeCell(cell, points);
        }
        return true;
    }

    void takeCell(vtkIdType cell, std::vector<int>& points)
    {
        const std::size_t n = points.size();
        switch (m_data.GetCellType(cell)) {
        case VTK_LINE:
        case VTK_POLY_LINE:
            for (std::size_t i = 1; i < n; ++i)
                m_mesh.lines.push_back({points[i - 1], points[i]});
            break;
        case VTK_TRIANGLE:
        case VTK_QUAD:
        case VTK_POLYGON:
            addFace(cell, points);
            break;
        case VTK_PIXEL: // a quad whose corners go by rows
            if (n == 4)
                std::swap(points[2], points[3]);
            addFace(cell, points);
            break;
        case VTK_TRIANGLE_STRIP:
            for (std::size_t i = 2; i < n; ++i) // every other one is turned over
                addFace(cell, {points[i - 2 + i % 2], points[i - 1 - i % 2], points[i]});
            break;
        case VTK_QUADRATIC_TRIANGLE: // the points amid the sides come last
            points.resize(std::min<std::size_t>(n, 3));
            addFace(cell, points);
            break;
        case VTK_QUADRATIC_QUAD:
        case VTK_BIQUADRATIC_QUAD:
            points.resize(std::min<std::size_t>(n, 4));
            addFace(cell, points);
            break;
        default:
            ++m_mesh.strayElements;
        }
    }

    void addFace(vtkIdType cell, const std::vector<int>& points)
    {
        if (points.size() < 3) {
            ++m_mesh.strayElements;
            return;
        }
        for (const int point : points) {
            m_isCorner[std::size_t(point)] = true;
            m_mesh.corners.push_back(point);
            if (m_texture && point < m_texture->GetNumberOfTuples())
                m_mesh.texture.push_back(
                    {m_texture->GetComponent(point, 0), m_texture->GetComponent(point, 1)});
            else if (m_texture)
                m_mesh.texture.push_back(PolygonMesh::noTexture());
        }
        m_mesh.endFace(0, materialOf(cell));
    }

    int materialOf(vtkIdType cell)
    {
        const bool isSaid = m_materials && cell < m_materials->GetNumberOfTuples();
        const double said = isSaid ? m_materials->GetComponent(cell, 0) : 0.0;
        const bool isNumber = std::abs(said) <= double(std::numeric_limits<int>::max());
        const int number = isNumber && m_materialOf.size() < mostMaterials ? int(said) : 0;
        const auto [found, isNew] = m_materialOf.try_emplace(number, int(m_mesh.materials.size()));
        if (isNew)
            m_mesh.materials.push_back(
                {isSaid ? "material " + std::to_string(number) : "", "", ""});
        return found->second;
    }

    void keepLines()
    {
        const auto isCorner = [&](int point) { return bool(m_isCorner[std::size_t(point)]); };
        m_mesh.strayElements += std::erase_if(m_mesh.lines, [&](const auto& ends) {
            return ends[0] == ends[1] || (isCorner(ends[0]) && isCorner(ends[1]));
        });
    }

    vtkPointSet& m_data;
    vtkDataArray* m_texture = nullptr;   // of points, or null
    vtkDataArray* m_materials = nullptr; // of cells, or null
    std::vector<bool> m_isCorner;        // [points]
    std::map<int, int> m_materialOf;     // by what the file says
    PolygonMesh m_mesh;
    std::string m_trouble;
};

std::string read(vtkXMLReader& reader, const std::string& file, const Complaints& complaints,
                 const std::function<void(double)>& tell)
{
    reader.SetFileName(file.c_str());
    reader.Update();
    tell(shareOfFile);
    auto* data = vtkPointSet::SafeDownCast(reader.GetOutputAsDataSet());
    if (const std::string why = complaints.first(); !why.empty())
        return troubleRecord(ReadTrouble::Unreadable, why);
    if (!data || reader.GetErrorCode() != 0 || data->GetNumberOfPoints() == 0)
        return troubleRecord(ReadTrouble::Unreadable, "it holds no points");
    Collector collector(*data);
    if (!collector.collect())
        return troubleRecord(ReadTrouble::Unreadable, collector.trouble());
    return meshRecord(collector.mesh());
}

} // namespace

std::string answerOfVtk(const std::string& file, const std::function<void(double)>& tell)
{
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(file, error);
    if (!error && size > ReadLimits::mostBytes)
        return troubleRecord(ReadTrouble::TooManyBytes);
    limitProcess(error ? 0 : size);
    vtkNew<Complaints> complaints;
    vtkOutputWindow::SetInstance(complaints);
    if (file.ends_with("u") || file.ends_with("U")) {
        vtkNew<vtkXMLUnstructuredGridReader> reader;
        return read(*reader, file, *complaints, tell);
    }
    vtkNew<vtkXMLPolyDataReader> reader;
    return read(*reader, file, *complaints, tell);
}

#else

namespace ripstop {

std::string answerOfVtk(const std::string&, const std::function<void(double)>&)
{
    return troubleRecord(ReadTrouble::UnknownFormat);
}

#endif

bool isVtkFile(const std::string& file)
{
    const std::string ending = lowerCase(std::filesystem::path(file).extension().string());
    return ending == ".vtp" || ending == ".vtu";
}

} // namespace ripstop
