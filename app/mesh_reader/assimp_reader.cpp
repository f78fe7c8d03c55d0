// The file is read by assimp, which opens files through BoundedFiles only; Collector copies each of
// the meshes that come of it as often as a node shows it, at the place of the node.
#include "mesh_reader/assimp_reader.h"

#include "base/tubes_mark.h"
#include "mesh_reader/bounded_files.h"

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/scene.h>

#include <algorithm>
#include <cstdio>

namespace ripstop {
namespace {

constexpr double shareOfFile = 0.7; // of the progress, the rest is copying
constexpr double leastNews = 0.005; // of the progress

class ProgressTeller final : public Assimp::ProgressHandler
{
public:
    explicit ProgressTeller(const std::function<void(double)>& tell)
        : m_tell(tell)
    {}

    bool Update(float share) override
    {
        const double now = shareOfFile * std::clamp(double(share), 0.0, 1.0);
        if (now >= m_told + leastNews)
            m_tell(m_told = now);
        return true;
    }

private:
    const std::function<void(double)>& m_tell;
    double m_told = 0.0;
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

// Where the picture is within the file, assimp gives its number after a star.
std::string pictureOf(const aiMaterial& material)
{
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
        aiString path;
        if (material.GetTexture(type, 0, &path) == aiReturn_SUCCESS)
            return path.C_Str();
    }
    return {};
}

PolygonMesh::PackedPicture packed(const aiTexture& texture)
{
    PolygonMesh::PackedPicture picture;
    const std::string name = texture.mFilename.C_Str();
    picture.name = name.starts_with('*') ? std::string() : name;
    if (texture.mHeight == 0) // a file as it is, of so many bytes
        picture.bytes.assign(reinterpret_cast<const char*>(texture.pcData), texture.mWidth);
    return picture;
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
            m_mesh.materials.push_back(
                {material.GetName().C_Str(), colorOf(material), pictureOf(material)});
        }
        if (m_mesh.materials.empty())
            m_mesh.materials.emplace_back();
        for (unsigned i = 0; i < scene.mNumTextures; ++i)
            m_mesh.pictures.push_back(packed(*scene.mTextures[i]));
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
        const bool isTubes = node.mMetaData && node.mMetaData->HasKey(tubesMark);
        for (unsigned i = 0; i < node.mNumMeshes && !isTubes; ++i) {
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
                if (face.mNumIndices == 2)
                    m_mesh.lines.push_back(
                        {firstPoint + int(face.mIndices[0]), firstPoint + int(face.mIndices[1])});
                else
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

} // namespace

std::string answerOfAssimp(const std::string& file, const std::function<void(double)>& tell)
{
    Assimp::Importer importer;
    const std::size_t dot = file.rfind('.');
    if (dot == std::string::npos || !importer.IsExtensionSupported(file.substr(dot)))
        return troubleRecord(ReadTrouble::UnknownFormat);
    auto* files = new BoundedFiles;
    importer.SetIOHandler(files);                          // the importer deletes it
    importer.SetProgressHandler(new ProgressTeller(tell)); // and this
    const aiScene* scene = importer.ReadFile(file, 0);
    if (files->areTooLarge())
        return troubleRecord(ReadTrouble::TooManyBytes);
    if (!scene || !scene->mRootNode)
        return troubleRecord(ReadTrouble::Unreadable, importer.GetErrorString());
    const PolygonMesh mesh = Collector(*scene).collect();
    importer.FreeScene();
    return meshRecord(mesh);
}

} // namespace ripstop
