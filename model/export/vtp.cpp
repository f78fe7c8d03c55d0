// One moment as VTK PolyData: links are lines, panels are triangles, in that order. Arrays are
// exact, and stand compressed behind the XML, as ParaView writes them by itself.
#include "export/moment.h"

#include "export/standing.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

#include <zlib.h>

namespace ripstop {
namespace {

constexpr std::size_t blockSize = 1 << 20; // bytes, that are compressed together
constexpr int speed = 1;                   // of zlib, 1 to 9; more takes longer for a hundredth

// The XML of a file, and behind it the values of its arrays, each in compressed blocks
// (vtkZLibDataCompressor): how many, their size, that of the last where it is smaller, and how long
// each has become.
class VtkText
{
public:
    void add(std::string_view xml) { m_xml += xml; }

    // `type` is VTK's name of T; `components` is 1 or 3.
    template <typename T>
    void addArray(std::string_view name, std::string_view type, int components,
                  const std::vector<T>& values, std::string_view more = "")
    {
        m_xml.append("<DataArray type=\"").append(type).append("\" Name=\"").append(name);
        m_xml.append("\" NumberOfComponents=\"").append(std::to_string(components)).append("\" ");
        m_xml.append(more).append("format=\"appended\" offset=\"");
        m_xml.append(std::to_string(m_values.size())).append("\"/>\n");
        append({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
    }

    std::string whole() const
    {
        return m_xml + "<AppendedData encoding=\"raw\">\n_" + m_values
               + "\n</AppendedData>\n</VTKFile>\n";
    }

private:
    void append(std::string_view bytes)
    {
        const std::uint64_t blocks = (bytes.size() + blockSize - 1) / blockSize;
        std::vector<std::uint64_t> head{blocks, blockSize, bytes.size() % blockSize};
        std::string packed;
        for (std::size_t i = 0; i < blocks; ++i)
            head.push_back(appendBlock(packed, bytes.substr(i * blockSize, blockSize)));
        m_values.append(reinterpret_cast<const char*>(head.data()),
                        head.size() * sizeof(std::uint64_t));
        m_values += packed;
    }

    static std::uint64_t appendBlock(std::string& packed, std::string_view bytes)
    {
        const std::size_t begin = packed.size();
        uLongf size = compressBound(uLong(bytes.size()));
        packed.resize(begin + size); // never too small
        compress2(reinterpret_cast<Bytef*>(packed.data() + begin), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()), speed);
        packed.resize(begin + size);
        return size;
    }

    std::string m_xml;
    std::string m_values;
};

void addNumbers(VtkText& text, std::string_view name, const std::vector<double>& values)
{
    text.addArray(name, "Float64", 1, values);
}

void addVectors(VtkText& text, std::string_view name, const std::vector<Vec3>& values)
{
    text.addArray(name, "Float64", 3, values);
}

struct Cells
{
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
};

void addCells(VtkText& text, std::string_view name, const Cells& cells)
{
    text.add("<" + std::string(name) + ">\n");
    text.addArray("connectivity", "Int64", 1, cells.connectivity);
    text.addArray("offsets", "Int64", 1, cells.offsets);
    text.add("</" + std::string(name) + ">\n");
}

// How many torn links end at each particle.
std::vector<double> tearsAt(const Frame& frame)
{
    std::vector<double> count(frame.position.size());
    for (std::size_t i = 0; i < frame.layout->links.size(); ++i)
        if (frame.torn[i]) {
            ++count[std::size_t(frame.layout->links[i].a)];
            ++count[std::size_t(frame.layout->links[i].b)];
        }
    return count;
}

std::uint64_t edgeOf(int a, int b)
{
    return std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b));
}

// The strain of a panel that carries the pull of its fabric is that of its threads, of others the
// largest of the links along their edges.
std::vector<double> panelStrains(const Frame& frame, const Standing& whole)
{
    std::unordered_map<std::uint64_t, double> along; // by edge
    along.reserve(whole.links.size());
    for (const std::size_t i : whole.links) {
        const Layout::Link& link = frame.layout->links[i];
        const auto [entry, isNew] = along.emplace(edgeOf(link.a, link.b), frame.strain[i]);
        entry->second = isNew ? entry->second : std::max(entry->second, frame.strain[i]);
    }
    std::vector<double> strains;
    for (const std::size_t i : whole.panels) {
        if (!frame.panelPull.empty() && frame.panelPull[i].carries) {
            strains.push_back(frame.panelPull[i].strain);
            continue;
        }
        const auto& corner = frame.layout->panelCorners[i];
        std::optional<double> largest;
        for (const std::size_t k : {0u, 1u, 2u})
            if (const auto edge = along.find(edgeOf(corner[k], corner[(k + 1) % 3]));
                edge != along.end())
                largest = std::max(largest.value_or(edge->second), edge->second);
        strains.push_back(largest.value_or(0.0));
    }
    return strains;
}

// Of a scene in which panels carry the pull of a fabric: how hard, and how they lie. Links have
// neither.
void addPulls(VtkText& text, const Frame& frame, const Standing& whole)
{
    if (frame.panelPull.empty())
        return;
    std::vector<double> tension(whole.links.size(), 0.0);
    constexpr std::int64_t none = -1;
    std::vector<std::int64_t> state(whole.links.size(), none);
    for (const std::size_t i : whole.panels) {
        const PanelPull& pull = frame.panelPull[i];
        tension.push_back(pull.tension);
        state.push_back(pull.carries ? std::int64_t(pull.state) : none);
    }
    addNumbers(text, "panel tension (N/m)", tension);
    text.addArray("cloth (0 slack, 1 wrinkled, 2 taut)", "Int64", 1, state);
}

void addCellData(VtkText& text, const Frame& frame, const Standing& whole)
{
    std::vector<double> strain;
    std::vector<double> tension;
    std::vector<Vec3> load(whole.links.size(), Vec3::Zero());
    std::vector<std::int64_t> id;
    for (const std::size_t i : whole.links) {
        strain.push_back(frame.strain[i]);
        tension.push_back(frame.tension[i]);
        id.push_back(frame.layout->links[i].id);
    }
    const std::vector<double> fabric = panelStrains(frame, whole);
    strain.insert(strain.end(), fabric.begin(), fabric.end());
    tension.resize(strain.size(), 0.0);
    for (const std::size_t i : whole.panels) {
        load.push_back(frame.panelLoad[i]);
        id.push_back(frame.layout->panelId[i]);
    }
    text.add("<CellData Scalars=\"strain (1)\" Vectors=\"panel load (N)\">\n");
    addNumbers(text, "strain (1)", strain);
    addNumbers(text, "tension (N)", tension);
    addVectors(text, "panel load (N)", load);
    text.addArray("id", "Int64", 1, id);
    addPulls(text, frame, whole);
    text.add("</CellData>\n");
}

} // namespace

Result<std::string> vtpMoment(const Frame& frame, const MeshAppearance&)
{
    const Standing whole = standing(frame);
    Cells lines;
    for (const std::size_t i : whole.links) {
        lines.connectivity.push_back(frame.layout->links[i].a);
        lines.connectivity.push_back(frame.layout->links[i].b);
        lines.offsets.push_back(std::int64_t(lines.connectivity.size()));
    }
    Cells polys;
    for (const std::size_t i : whole.panels) {
        for (const int corner : frame.layout->panelCorners[i])
            polys.connectivity.push_back(corner);
        polys.offsets.push_back(std::int64_t(polys.connectivity.size()));
    }
    const std::vector<std::int64_t> id(frame.layout->particleId.begin(),
                                       frame.layout->particleId.end());

    VtkText text;
    text.add("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
             "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\" byte_order=\"");
    text.add(std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
    text.add("\">\n<PolyData>\n<FieldData>\n");
    text.addArray("TimeValue", "Float64", 1, std::vector{frame.time}, "NumberOfTuples=\"1\" ");
    text.add("</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(frame.position.size())
             + R"(" NumberOfVerts="0" NumberOfLines=")" + std::to_string(whole.links.size())
             + R"(" NumberOfStrips="0" NumberOfPolys=")" + std::to_string(whole.panels.size())
             + "\">\n<PointData Vectors=\"velocity (m/s)\">\n");
    addVectors(text, "velocity (m/s)", frame.velocity);
    addNumbers(text, "torn links (1)", tearsAt(frame));
    text.addArray("id", "Int64", 1, id);
    text.add("</PointData>\n");
    addCellData(text, frame, whole);
    text.add("<Points>\n");
    addVectors(text, "Points", frame.position);
    text.add("</Points>\n");
    addCells(text, "Lines", lines);
    addCells(text, "Polys", polys);
    text.add("</Piece>\n</PolyData>\n");
    return text.whole();
}

} // namespace ripstop
