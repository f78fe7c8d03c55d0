// STL and Collada by assimp, which writes them from its own kind of scene.
#include "export/moment.h"

#include <assimp/Exporter.hpp>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <memory>

namespace ripstop {
namespace {

aiVector3D single(const Vec3& v) { return {ai_real(v.x()), ai_real(v.y()), ai_real(v.z())}; }

// Some faces of a surface with those of its vertices that they use. An aiMesh deletes what it
// holds. Lines have places alone: with more of them assimp writes Collada that breaks its schema.
template <std::size_t corners>
std::unique_ptr<aiMesh> meshOf(const Surface& surface, const std::vector<Vec3>& normals,
                               const std::vector<std::array<int, corners>>& faces,
                               const std::string& name)
{
    std::vector<std::size_t> used;
    std::vector<int> number(surface.position.size(), -1);
    for (const auto& face : faces)
        for (const int corner : face)
            if (int& n = number[std::size_t(corner)]; n < 0) {
                n = int(used.size());
                used.push_back(std::size_t(corner));
            }

    auto mesh = std::make_unique<aiMesh>();
    mesh->mName = name;
    mesh->mNumVertices = unsigned(used.size());
    mesh->mVertices = new aiVector3D[used.size()];
    std::ranges::transform(used, mesh->mVertices,
                           [&](std::size_t i) { return single(surface.position[i]); });
    if (corners == 3) {
        mesh->mNormals = new aiVector3D[used.size()];
        std::ranges::transform(used, mesh->mNormals,
                               [&](std::size_t i) { return single(normals[i]); });
    }
    if (corners == 3 && !surface.texture.empty()) {
        mesh->mNumUVComponents[0] = 2;
        mesh->mTextureCoords[0] = new aiVector3D[used.size()];
        std::ranges::transform(used, mesh->mTextureCoords[0], [&](std::size_t i) {
            const auto& [u, v] = surface.texture[i];
            return aiVector3D(ai_real(u), ai_real(v), 0);
        });
    }

    mesh->mNumFaces = unsigned(faces.size());
    mesh->mFaces = new aiFace[faces.size()];
    for (std::size_t i = 0; i < faces.size(); ++i) {
        mesh->mFaces[i].mNumIndices = corners;
        mesh->mFaces[i].mIndices = new unsigned[corners];
        std::ranges::transform(faces[i], mesh->mFaces[i].mIndices,
                               [&](int corner) { return unsigned(number[std::size_t(corner)]); });
    }
    mesh->mPrimitiveTypes = corners == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_LINE;
    return mesh;
}

std::unique_ptr<aiMaterial> materialOf(const MeshAppearance::Fabric& fabric)
{
    auto material = std::make_unique<aiMaterial>();
    const aiString name(fabric.name);
    const aiColor3D color(ai_real(fabric.color[0]), ai_real(fabric.color[1]),
                          ai_real(fabric.color[2]));
    material->AddProperty(&name, AI_MATKEY_NAME);
    material->AddProperty(&color, 1, AI_MATKEY_COLOR_DIFFUSE);
    return material;
}

// One mesh for the panels of each fabric, and one for its lines.
std::unique_ptr<aiScene> sceneOf(const Surface& surface, bool withLines)
{
    const std::vector<Vec3> normals = normalsOf(surface);
    std::vector<std::unique_ptr<aiMesh>> meshes;
    const auto add = [&](std::size_t fabric, const auto& elements) {
        if (elements.empty())
            return;
        meshes.push_back(meshOf(surface, normals, elements, surface.fabrics[fabric].name));
        meshes.back()->mMaterialIndex = unsigned(fabric);
    };
    for (std::size_t fabric = 0; fabric < surface.fabrics.size(); ++fabric) {
        add(fabric, madeOf(fabric, surface.fabric, surface.panels));
        if (withLines)
            add(fabric, madeOf(fabric, surface.lineFabric, surface.lines));
    }

    auto scene = std::make_unique<aiScene>();
    scene->mNumMaterials = unsigned(surface.fabrics.size());
    scene->mMaterials = new aiMaterial*[surface.fabrics.size()];
    std::ranges::transform(
        surface.fabrics, scene->mMaterials,
        [](const MeshAppearance::Fabric& fabric) { return materialOf(fabric).release(); });
    auto root = std::make_unique<aiNode>(surface.name);
    root->mNumMeshes = scene->mNumMeshes = unsigned(meshes.size());
    root->mMeshes = new unsigned[meshes.size()];
    scene->mMeshes = new aiMesh*[meshes.size()];
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        root->mMeshes[i] = unsigned(i);
        scene->mMeshes[i] = meshes[i].release();
    }
    scene->mRootNode = root.release();
    return scene;
}

// Each panel with corners of its own, so that their normals are that of the panel.
Surface apart(const Surface& surface)
{
    Surface facets;
    facets.name = surface.name;
    facets.fabrics = surface.fabrics;
    facets.fabric = surface.fabric;
    for (const auto& panel : surface.panels) {
        const int first = int(facets.position.size());
        facets.panels.push_back({first, first + 1, first + 2});
        for (const int corner : panel)
            facets.position.push_back(surface.position[std::size_t(corner)]);
    }
    return facets;
}

Result<std::string> exported(const aiScene& scene, const char* format)
{
    if (scene.mNumMeshes == 0)
        return Failure{"There is neither fabric nor a line at this moment to make a mesh of."};
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, format);
    if (!blob)
        return Failure("The mesh cannot be written: %1", exporter.GetErrorString());
    return std::string(static_cast<const char*>(blob->data), blob->size);
}

} // namespace

Result<std::string> stlMoment(const Frame& frame, const MeshAppearance& appearance)
{
    return exported(*sceneOf(apart(surfaceOf(frame, appearance)), false), "stlb");
}

Result<std::string> colladaMoment(const Frame& frame, const MeshAppearance& appearance)
{
    return exported(*sceneOf(surfaceOf(frame, appearance), true), "collada");
}

} // namespace ripstop
