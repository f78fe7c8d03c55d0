#include "shapes/mesh_file.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace ripstop {

Result<TriangleTree> readMeshFile(const std::filesystem::path& file)
{
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // positions only, so that corners which differ in colour or normal alone are one
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS
                                    | aiComponent_COLORS | aiComponent_TEXCOORDS
                                    | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS
                                    | aiComponent_TEXTURES | aiComponent_LIGHTS
                                    | aiComponent_CAMERAS | aiComponent_MATERIALS);
    const aiScene* scene = importer.ReadFile(
        file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent
                           | aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
    if (!scene)
        return Failure{"The mesh " + file.string() + " cannot be read (" + importer.GetErrorString()
                       + "); save it as OBJ, STL or PLY, or choose another file."};
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        const int first = int(points.size());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& p = mesh.mVertices[i];
            points.emplace_back(p.x, p.y, p.z);
            if (!points.back().allFinite())
                return Failure{"The mesh " + file.string()
                               + " has a point that is not a number; save it again or choose "
                                 "another file."};
        }
        for (unsigned i = 0; i < mesh.mNumFaces; ++i)
            if (const aiFace& face = mesh.mFaces[i]; face.mNumIndices == 3)
                triangles.push_back({first + int(face.mIndices[0]), first + int(face.mIndices[1]),
                                     first + int(face.mIndices[2])});
    }
    TriangleTree tree(std::move(points), triangles);
    if (tree.faces().empty())
        return Failure{"The mesh " + file.string()
                       + " has no triangles; choose a file with a surface."};
    return tree;
}

} // namespace ripstop
