// One moment as VTK PolyData: links are lines, panels are triangles, in that order. Arrays are
// base64 with their length in bytes before them, so the file is small, exact and still XML.
#include "export/moment.h"

#include "export/standing.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <unordered_map>

namespace ripstop {
namespace {

// RFC 4648
void appendBase64(std::string& text, std::string_view bytes)
{
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t begin = text.size();
    text.resize(begin + (bytes.size() + 2) / 3 * 4);
    char* out = text.data() + begin;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? unsigned(static_cast<unsigned char>(bytes[i + k])) : 0u;
        };
        const unsigned word = byte(0) << 16 | byte(1) << 8 | byte(2);
        *out++ = digits[word >> 18];
        *out++ = digits[word >> 12 & 63];
        *out++ = i + 1 < bytes.size() ? digits[word >> 6 & 63] : '=';
        *out++ = i + 2 < bytes.size() ? digits[word & 63] : '=';
    }
}

// `type` is VTK's name of T; `components` is 1 or 3.
template <typename T>
void addArray(std::string& text, std::string_view name, std::string_view type, int components,
              const std::vector<T>& values, std::string_view more = "")
{
    const std::uint64_t size = values.size() * sizeof(T);
    std::string bytes(sizeof size + size, '\0');
    std::memcpy(bytes.data(), &size, sizeof size);
    if (size > 0)
        std::memcpy(bytes.data() + sizeof size, static_cast<const void*>(values.data()), size);
    text.append("<DataArray type=\"").append(type).append("\" Name=\"").append(name);
    text.append("\" NumberOfComponents=\"").append(std::to_string(components)).append("\" ");
    text.append(more).append("format=\"binary\">");
    appendBase64(text, bytes);
    text += "</DataArray>\n";
}

void addNumbers(std::string& text, std::string_view name, const std::vector<double>& values)
{
    addArray(text, name, "Float64", 1, values);
}

void addVectors(std::string& text, std::string_view name, const std::vector<Vec3>& values)
{
    addArray(text, name, "Float64", 3, values);
}

struct Cells
{
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
};

void addCells(std::string& text, std::string_view name, const Cells& cells)
{
    text.append("<").append(name).append(">\n");
    addArray(text, "connectivity", "Int64", 1, cells.connectivity);
    addArray(text, "offsets", "Int64", 1, cells.offsets);
    text.append("</").append(name).append(">\n");
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
void addPulls(std::string& text, const Frame& frame, const Standing& whole)
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
    addArray(text, "cloth (0 slack, 1 wrinkled, 2 taut)", "Int64", 1, state);
}

void addCellData(std::string& text, const Frame& frame, const Standing& whole)
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
    text += "<CellData Scalars=\"strain (1)\" Vectors=\"panel load (N)\">\n";
    addNumbers(text, "strain (1)", strain);
    addNumbers(text, "tension (N)", tension);
    addVectors(text, "panel load (N)", load);
    addArray(text, "id", "Int64", 1, id);
    addPulls(text, frame, whole);
    text += "</CellData>\n";
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

    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                       "header_type=\"UInt64\" byte_order=\"";
    text += std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
    text += "\">\n<PolyData>\n<FieldData>\n";
    addArray(text, "TimeValue", "Float64", 1, std::vector{frame.time}, "NumberOfTuples=\"1\" ");
    text += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(frame.position.size())
            + R"(" NumberOfVerts="0" NumberOfLines=")" + std::to_string(whole.links.size())
            + R"(" NumberOfStrips="0" NumberOfPolys=")" + std::to_string(whole.panels.size())
            + "\">\n<PointData Vectors=\"velocity (m/s)\">\n";
    addVectors(text, "velocity (m/s)", frame.velocity);
    addNumbers(text, "torn links (1)", tearsAt(frame));
    addArray(text, "id", "Int64", 1, id);
    text += "</PointData>\n";
    addCellData(text, frame, whole);
    text += "<Points>\n";
    addVectors(text, "Points", frame.position);
    text += "</Points>\n";
    addCells(text, "Lines", lines);
    addCells(text, "Polys", polys);
    text += "</Piece>\n</PolyData>\n</VTKFile>\n";
    return text;
}

} // namespace ripstop
