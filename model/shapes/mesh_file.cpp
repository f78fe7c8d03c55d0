// Reads mesh files in these stages:
// 1. refusal() looks at the file before it is opened: whether it exists, and its size.
// 2. OBJ, PLY and OFF go to readers of our own, all others to assimp or VTK in a process of its own
//    (mesh_process.h).
// 3. Pictures of materials are looked for, a mesh without faces or with points that are not finite
// is refused; exceptions end here.
// 4. readMeshFile() makes a collider of it: it splits polygons into triangles and joins points at
//    the same place, because a tree of loose triangles would never be closed.
#include "shapes/mesh_file.h"

#include "base/lower_case.h"
#include "shapes/mesh_process.h"
#include "shapes/obj_file.h"
#include "shapes/packed_pictures.h"
#include "shapes/ply_file.h"
#include "shapes/polygon_split.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

namespace ripstop {
namespace {

constexpr std::array<std::string_view, 9> extensions{"obj", "stl", "ply", "off", "gltf",
                                                     "glb", "dae", "vtp", "vtu"};

std::string extensionOf(const std::filesystem::path& file)
{
    std::string extension = lowerCase(file.extension().string());
    if (!extension.empty())
        extension.erase(0, 1);
    return extension;
}

Failure unread(const std::filesystem::path& file, std::string_view why)
{
    return Failure("The mesh %1 cannot be read (%2).", file.string(), why);
}

// Whether an STL file of text ends before its end, of which its reader makes fewer triangles. A
// binary one may begin with the same word, but is as long as its count says.
bool isCutOff(const std::filesystem::path& file, std::uintmax_t size)
{
    constexpr std::uintmax_t header = 84, triangle = 50, tail = 1024; // bytes
    std::ifstream stream(file, std::ios::binary);
    std::array<char, header> begin{};
    stream.read(begin.data(), begin.size());
    std::uint32_t count = 0;
    std::memcpy(&count, begin.data() + header - sizeof count, sizeof count);
    if (!std::string_view(begin.data(), begin.size()).starts_with("solid")
        || size == header + triangle * count)
        return false;
    stream.clear();
    stream.seekg(std::streamoff(size - std::min(size, tail)));
    const std::string end{std::istreambuf_iterator<char>(stream), {}};
    return lowerCase(end).find("endsolid") == std::string::npos;
}

// The reason why reading the file would be pointless, or nothing.
std::optional<Failure> refusal(const std::filesystem::path& file)
{
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        return Failure("The mesh %1 does not exist; check the name and the folder.", file.string());
    if (std::filesystem::is_directory(status))
        return Failure("The mesh %1 is a folder; choose a file in it.", file.string());
    if (!std::filesystem::is_regular_file(status))
        return std::nullopt; // a pipe has no size
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        return unread(file, error.message());
    if (size == 0)
        return Failure("The mesh %1 is empty; save it again.", file.string());
    if (size > ReadLimits::mostBytes)
        return Failure("The mesh %1 is larger than 1 GiB; make it coarser in a mesh program first.",
                       file.string());
    if (extensionOf(file) == "stl" && isCutOff(file, size))
        return unread(file, "it ends in the middle of a solid");
    return std::nullopt;
}

Result<std::string> contentOf(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return Failure("The mesh %1 cannot be opened; check that you may read it.", file.string());
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad())
        return Failure("The mesh %1 cannot be read to its end; check the disk.", file.string());
    return text;
}

// A file that a mesh names, in its folder or below; nothing where it is not there. A mesh of
// strangers has nothing to say about files elsewhere.
std::optional<std::filesystem::path> fileBelow(const std::filesystem::path& folder,
                                               const std::filesystem::path& name)
{
    const std::filesystem::path plain = name.lexically_normal();
    std::error_code error;
    if (plain.empty() || plain.has_root_path() || *plain.begin() == ".."
        || !std::filesystem::is_regular_file(folder / plain, error))
        return std::nullopt;
    return folder / plain;
}

// Those that an OBJ names (mtllib), by a line with blanks in a name or with several names; where
// none of them is there, that of its own name. The mesh keeps the names that led nowhere.
std::vector<std::filesystem::path> takeMaterialFiles(PolygonMesh& mesh,
                                                     const std::filesystem::path& file)
{
    std::vector<std::filesystem::path> found;
    const auto take = [&](const std::string& name) {
        const auto place = fileBelow(file.parent_path(), name);
        if (place)
            found.push_back(*place);
        return place.has_value();
    };
    for (const std::string& line : mesh.materialFiles) {
        if (take(line))
            continue;
        std::vector<std::string> missing;
        std::istringstream words(line);
        const std::size_t before = found.size();
        for (std::string word; words >> word;)
            if (!take(word))
                missing.push_back(word);
        if (found.size() == before) // a name with blanks
            missing = {line};
        mesh.missingFiles.insert(mesh.missingFiles.end(), missing.begin(), missing.end());
    }
    if (found.empty() && take(file.filename().replace_extension(".mtl").string()))
        mesh.missingFiles.clear();
    return found;
}

Result<PolygonMesh> readObjFile(const std::filesystem::path& file, const Progress& progress)
{
    const Result<std::string> text = contentOf(file);
    if (!text)
        return text.failure();
    Result<PolygonMesh> mesh = readObj(*text, file.string(), progress);
    // A missing or broken file of materials is no reason to refuse the mesh.
    if (mesh)
        for (const std::filesystem::path& colors : takeMaterialFiles(*mesh, file))
            if (const Result<std::string> list = contentOf(colors))
                readMtl(*list, *mesh);
    return mesh;
}

// Of a URI, "%20" is a space and so on.
std::string decoded(std::string_view uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* const digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size()
            && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            text += char(byte);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

// The places of pictures from here. Of those that are not there the mesh keeps the names.
void findPictures(const std::filesystem::path& file, PolygonMesh& mesh)
{
    nameFilesBeside(file, mesh.pictures);
    for (PolygonMesh::Material& material : mesh.materials) {
        const std::string named = std::exchange(material.picture, {});
        if (named.empty())
            continue;
        if (named.front() == '*' && !mesh.pictures.empty()) {
            std::size_t index = 0;
            std::from_chars(named.data() + 1, named.data() + named.size(), index);
            if (index < mesh.pictures.size())
                material.picture = mesh.pictures[index].file;
            continue;
        }
        for (const std::string& name : {named, decoded(named)}) {
            const std::filesystem::path picture = file.parent_path() / name;
            std::error_code error;
            if (material.picture.empty() && std::filesystem::is_regular_file(picture, error))
                material.picture =
                    std::filesystem::absolute(picture, error).lexically_normal().string();
        }
        if (material.picture.empty()
            && std::ranges::find(mesh.missingFiles, named) == mesh.missingFiles.end())
            mesh.missingFiles.push_back(named);
    }
}

using ReadText = Result<PolygonMesh> (*)(std::string_view, const std::string&, const Progress&);

Result<PolygonMesh> readOwn(ReadText read, const std::filesystem::path& file,
                            const Progress& progress)
{
    const Result<std::string> content = contentOf(file);
    return content ? read(*content, file.string(), progress) : content.failure();
}

} // namespace

std::span<const std::string_view> meshExtensions() { return extensions; }

Result<PolygonMesh> readPolygonFile(const std::filesystem::path& file, const Progress& progress)
try {
    if (const auto failure = refusal(file))
        return *failure;
    const std::string extension = extensionOf(file);
    Result<PolygonMesh> mesh = extension == "obj"   ? readObjFile(file, progress)
                               : extension == "ply" ? readOwn(readPly, file, progress)
                               : extension == "off" ? readOwn(readOff, file, progress)
                                                    : readInOwnProcess(file, progress);
    if (!mesh)
        return mesh;
    if (mesh->faceCount() == 0)
        return Failure("The mesh %1 has no faces; choose a file with a surface.", file.string());
    for (std::size_t i = 0; i < mesh->points.size(); ++i)
        if (!mesh->points[i].allFinite())
            return Failure(
                "The mesh %1 has a vertex that is not finite (the one at place %2); save it "
                "again.",
                file.string(), i + 1);
    if (extension == "gltf" || extension == "glb" || extension == "dae") {
        mesh->unit = 1.0; // assimp converts these formats
        mesh->isUpright = true;
    }
    findPictures(file, *mesh);
    return mesh;
} catch (const std::exception& error) {
    return unread(file, error.what());
}

Result<TriangleTree> readMeshFile(const std::filesystem::path& file)
{
    const Result<PolygonMesh> mesh = readPolygonFile(file);
    if (!mesh)
        return mesh.failure();
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t i = 0; i < mesh->faceCount(); ++i)
        splitPolygon(mesh->face(i), mesh->points, triangles);
    // Corners that differ in texture alone, or are those of loose triangles, become one.
    const std::vector<int> target = welded(mesh->points, 0.0);
    std::vector<int> place(target.size());
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < target.size(); ++i) {
        const bool stays = target[i] == int(i);
        place[i] = stays ? int(points.size()) : place[std::size_t(target[i])];
        if (stays)
            points.push_back(mesh->points[i]);
    }
    for (std::array<int, 3>& triangle : triangles)
        for (int& corner : triangle)
            corner = place[std::size_t(corner)];
    TriangleTree tree(std::move(points), triangles);
    if (tree.faces().empty())
        return Failure("The mesh %1 has no face with an area; choose a file with a surface.",
                       file.string());
    return tree;
}

} // namespace ripstop
