// The records are written, each in one piece; then they are taken apart as their bytes come, and a
// mesh is looked at before anybody uses its indices.
#include "shapes/mesh_answer.h"

#include "base/bytes.h"

#include <algorithm>
#include <cmath>

namespace ripstop {

template <>
inline constexpr auto fieldsOf<PolygonMesh::Material> =
    fields<PolygonMesh::Material, &PolygonMesh::Material::name, &PolygonMesh::Material::color,
           &PolygonMesh::Material::picture>;

template <>
inline constexpr auto fieldsOf<PolygonMesh::PackedPicture> =
    fields<PolygonMesh::PackedPicture, &PolygonMesh::PackedPicture::name,
           &PolygonMesh::PackedPicture::bytes, &PolygonMesh::PackedPicture::file>;

template <>
inline constexpr auto fieldsOf<PolygonMesh> =
    fields<PolygonMesh, &PolygonMesh::points, &PolygonMesh::first, &PolygonMesh::corners,
           &PolygonMesh::texture, &PolygonMesh::object, &PolygonMesh::material,
           &PolygonMesh::objects, &PolygonMesh::materials, &PolygonMesh::materialFiles,
           &PolygonMesh::pictures, &PolygonMesh::missingFiles, &PolygonMesh::lines,
           &PolygonMesh::mass, &PolygonMesh::unit, &PolygonMesh::isUpright,
           &PolygonMesh::strayElements>;

namespace {

enum class RecordKind : std::uint8_t { Progress = 1, Trouble, Mesh };

constexpr std::size_t recordHead = 1 + sizeof(std::uint64_t);   // bytes
constexpr std::uint64_t longestText = 1 << 16;                  // bytes
constexpr std::uint64_t longestRecord = std::uint64_t(4) << 30; // bytes; some 40 million triangles

template <typename... Parts>
std::string recordOf(RecordKind kind, const Parts&... parts)
{
    ByteWriter writer;
    writer(kind, std::uint64_t(0), parts...);
    std::string record = writer.take();
    const std::uint64_t length = record.size() - recordHead;
    std::memcpy(record.data() + 1, &length, sizeof length);
    return record;
}

bool areBelow(const std::vector<int>& indices, std::size_t count)
{
    return std::ranges::all_of(indices, [&](int i) { return i >= 0 && std::size_t(i) < count; });
}

bool isSound(const PolygonMesh& mesh)
{
    const std::size_t corners = mesh.corners.size();
    return !mesh.first.empty() && mesh.first.front() == 0 && std::ranges::is_sorted(mesh.first)
           && std::size_t(mesh.first.back()) == corners
           && areBelow(mesh.corners, mesh.points.size())
           && (mesh.texture.empty() || mesh.texture.size() == corners)
           && mesh.object.size() == mesh.faceCount() && mesh.material.size() == mesh.faceCount()
           && areBelow(mesh.object, mesh.objects.size())
           && areBelow(mesh.material, mesh.materials.size())
           && std::ranges::all_of(
               mesh.lines,
               [&](const auto& ends) {
                   return areBelow({ends.begin(), ends.end()}, mesh.points.size());
               })
           && (mesh.mass.empty() || mesh.mass.size() == mesh.points.size());
}

} // namespace

std::string progressRecord(double share) { return recordOf(RecordKind::Progress, share); }

std::string troubleRecord(ReadTrouble trouble, std::string_view why)
{
    return recordOf(RecordKind::Trouble, trouble, std::string(why.substr(0, longestText / 2)));
}

std::string meshRecord(const PolygonMesh& mesh) { return recordOf(RecordKind::Mesh, mesh); }

bool MeshAnswer::take(std::string_view bytes)
{
    m_bytes += bytes;
    std::string_view left = m_bytes;
    while (!isOver() && left.size() >= recordHead) {
        const auto kind = std::uint8_t(left.front());
        std::uint64_t length = 0;
        std::memcpy(&length, left.data() + 1, sizeof length);
        const bool isMesh = RecordKind(kind) == RecordKind::Mesh;
        if (length > (isMesh ? longestRecord : longestText))
            return false;
        if (left.size() - recordHead < length)
            break;
        if (!takeRecord(kind, left.substr(recordHead, std::size_t(length))))
            return false;
        left.remove_prefix(recordHead + std::size_t(length));
    }
    m_bytes.erase(0, m_bytes.size() - left.size());
    return true;
}

bool MeshAnswer::takeRecord(std::uint8_t kind, std::string_view content)
{
    ByteReader reader(content);
    switch (RecordKind(kind)) {
    case RecordKind::Progress:
        reader(m_share);
        return reader.ok() && reader.atEnd() && m_share >= 0.0 && m_share <= 1.0;
    case RecordKind::Trouble: {
        ReadTrouble trouble{};
        reader(trouble, m_why);
        if (!reader.ok() || !reader.atEnd() || trouble > ReadTrouble::TooMuchMemory)
            return false;
        m_trouble = trouble;
        return true;
    }
    case RecordKind::Mesh: {
        PolygonMesh mesh;
        reader(mesh);
        if (!reader.ok() || !reader.atEnd() || !isSound(mesh))
            return false;
        m_mesh = std::move(mesh);
        return true;
    }
    }
    return false;
}

} // namespace ripstop
