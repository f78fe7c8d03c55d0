// The files that a scene names: meshes and pictures of colliders, pictures on fabric.
//
// Names are seen from the folder of the scene (shapes/shape_files.h: placeOfFile).
#pragma once

#include "scene/scene.h"
#include "shapes/shape_files.h"

#include <filesystem>
#include <string>

namespace ripstop {

// How a file is named that is seen from a folder, of which an empty one is the working directory;
// as it was where there is no way between the two.
std::string nameSeenFrom(const std::filesystem::path& folder, const std::filesystem::path& file);

// How a file is named in a scene that lies in another folder. An absolute path stays as it is, and
// so does that of a file that is not there: it may be meant to come.
std::string fileSeenFrom(const std::filesystem::path& newFolder, const Scene& scene,
                         const std::string& file);

// Each file that the scene names, for `visit` to see or to change: (name of the thing, file).
template <typename AnyScene, typename Visit>
void forEachFile(AnyScene& scene, Visit visit)
{
    for (auto& entry : scene.items) {
        if (auto* collider = std::get_if<Collider>(&entry.item);
            collider && !collider->file.empty())
            visit(collider->name, collider->file);
        if (auto* material = std::get_if<Material>(&entry.item);
            material && !material->picture.empty())
            visit(material->name, material->picture);
    }
}

} // namespace ripstop
