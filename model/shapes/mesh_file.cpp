// Reads mesh files in these stages:
// 1. refusal() looks at the file before it is opened: whether it exists, its extension, its size.
// 2. OBJ, PLY and OFF go to readers of our own, all others to assimp, whose progress can cancel
//    it. Collector copies each of its meshes as often as a node shows it, at the place of the
//    node.
// 3. A mesh without faces or with points that are not finite is refused; exceptions end here.
// 4. readMeshFile() makes a collider of it: it splits polygons into triangles and joins points at
//    the same place, because a tree of loose triangles would never be closed.
#include "shapes/mesh_file.h"

#include "shapes/obj_file.h"
#include "shapes/ply_file.h"
#include "shapes/polygon_split.h"

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace ripstop {
namespace {

constexpr std::uintmax_t largestFile = std::uintmax_t(1) << 30; // bytes
constexpr double shareOfFile = 0.7; // of the progress, the rest is copying

constexpr std::array<std::string_view, 7> extensions{"obj",  "stl", "ply", "off",
                                                     "gltf", "glb", "dae"};

std::string extensionOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    if (!extension.empty())
        extension.erase(0, 1);
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

Failure unread(const std::filesystem::path& file, std::string_view why)
{
    return Failure("The mesh %1 cannot be read (%2).", file.string(), why);
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
    const std::string extension = extensionOf(file);
    const bool isKnown =
        std::ranges::find(extensions, extension) != extensions.end()
        || (!extension.empty() && Assimp::Importer().IsExtensionSupported(extension));
    if (!isKnown)
        return Failure(
            "The mesh %1 has no known format; choose an OBJ, STL, PLY, OFF, glTF, GLB or "
            "Collada (.dae) file.",
            file.string());
    if (!std::filesystem::is_regular_file(status))
        return std::nullopt; // a pipe has no size
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        return unread(file, error.message());
    if (size == 0)
        return Failure("The mesh %1 is empty; save it again.", file.string());
    if (size > largestFile)
        return Failure("The mesh %1 is larger than 1 GiB; make it coarser in a mesh program first.",
                       file.string());
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

class Listener final : public Assimp::ProgressHandler
{
public:
    explicit Listener(const Progress& progress)
        : m_progress(progress)
    {}

    bool Update(float share) override
    {
        m_goesOn =
            m_goesOn && goesOn(m_progress, shareOfFile * std::clamp(double(share), 0.0, 1.0));
        return m_goesOn;
    }

private:
    const Progress& m_progress;
    bool m_goesOn = true;
};

std::string colorOf(const aiMaterial& material)
{
    aiColor4D color;
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != aiReturn_SUCCESS)
        return {};
    const auto byte = [](float part) { return int(255.0f * std::clamp(part, 0.0f, 1.0f) + 0.5f); };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.r), byte(color.g), byte(color.b));
    return text;
}

// Copies the meshes of a scene of assimp, each as often as a node shows it.
class Collector
{
public:
    explicit Collector(const aiScene& scene)
        : m_scene(scene)
    {
        for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
            const aiMaterial& material = *scene.mMaterials[i];
            m_mesh.materials.push_back({material.GetName().C_Str(), colorOf(material)});
        }
        if (m_mesh.materials.empty())
            m_mesh.materials.emplace_back();
    }

    PolygonMesh collect()
    {
        add(*m_scene.mRootNode, aiMatrix4x4());
        if (!m_hasTexture)
            m_mesh.texture.clear();
        return std::move(m_mesh);
    }

private:
    void add(const aiNode& node, const aiMatrix4x4& above)
    {
        const aiMatrix4x4 place = above * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            const aiMesh& mesh = *m_scene.mMeshes[node.mMeshes[i]];
            const std::string name =
                node.mName.length > 0 ? node.mName.C_Str() : mesh.mName.C_Str();
            add(mesh, place, objectCalled(name));
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            add(*node.mChildren[i], place);
    }

    int objectCalled(const std::string& name)
    {
        const auto found = std::ranges::find(m_mesh.objects, name);
        const auto index = found - m_mesh.objects.begin();
        if (found == m_mesh.objects.end())
            m_mesh.objects.push_back(name);
        return int(index);
    }

    void add(const aiMesh& mesh, const aiMatrix4x4& place, int object)
    {
        const int firstPoint = int(m_mesh.points.size());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D p = place * mesh.mVertices[i];
            m_mesh.points.emplace_back(p.x, p.y, p.z);
        }
        const bool isMirrored = place.Determinant() < 0.0f;
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices < 3) {
                ++m_mesh.strayElements;
                continue;
            }
            for (unsigned c = 0; c < face.mNumIndices; ++c) {
                const unsigned at = face.mIndices[isMirrored ? face.mNumIndices - 1 - c : c];
                m_mesh.corners.push_back(firstPoint + int(at));
                m_mesh.texture.push_back(PolygonMesh::noTexture());
                if (const aiVector3D* texture = mesh.mTextureCoords[0]) {
                    m_mesh.texture.back() = {texture[at].x, texture[at].y};
                    m_hasTexture = true;
                }
            }
            m_mesh.endFace(object,
                           std::min(int(mesh.mMaterialIndex), int(m_mesh.materials.size()) - 1));
        }
    }

    const aiScene& m_scene;
    PolygonMesh m_mesh;
    bool m_hasTexture = false;
};

Result<PolygonMesh> readByAssimp(const std::filesystem::path& file, const Progress& progress)
{
    Assimp::Importer importer;
    importer.SetProgressHandler(new Listener(progress)); // the importer deletes it
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (!goesOn(progress, shareOfFile))
        return Failure{"The import was cancelled."};
    if (!scene || !scene->mRootNode)
        return Failure("The mesh %1 cannot be read (%2). The file may be cut off or of another "
                       "format; save it again, or choose another file.",
                       file.string(), importer.GetErrorString());
    return Collector(*scene).collect();
}

Result<PolygonMesh> readObjFile(const std::filesystem::path& file, const Progress& progress)
{
    const Result<std::string> text = contentOf(file);
    if (!text)
        return text.failure();
    Result<PolygonMesh> mesh = readObj(*text, file.string(), progress);
    // A missing or broken file of colours is no reason to refuse the mesh.
    const std::filesystem::path colors = std::filesystem::path(file).replace_extension(".mtl");
    std::error_code error;
    if (mesh && std::filesystem::is_regular_file(colors, error))
        if (const Result<std::string> list = contentOf(colors))
            readMtlColors(*list, *mesh);
    return mesh;
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
                                                    : readByAssimp(file, progress);
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
