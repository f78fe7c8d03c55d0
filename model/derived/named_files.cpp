#include "derived/named_files.h"

namespace ripstop {

std::string nameSeenFrom(const std::filesystem::path& folder, const std::filesystem::path& file)
{
    std::error_code error;
    const auto seen = std::filesystem::proximate(file, folder.empty() ? "." : folder, error);
    return (error ? file : seen).generic_string();
}

std::string fileSeenFrom(const std::filesystem::path& newFolder, const Scene& scene,
                         const std::string& file)
{
    namespace fs = std::filesystem;
    if (file.empty() || fs::path(file).is_absolute())
        return file;
    const auto orHere = [](const fs::path& folder) { return folder.empty() ? "." : folder; };
    const fs::path from = orHere(scene.folder.path), to = orHere(newFolder);
    const fs::path place = placeOfFile(scene.folder.path, file);
    std::error_code error;
    if (!fs::exists(place, error) || fs::equivalent(from, to, error))
        return file;
    return nameSeenFrom(to, place);
}

} // namespace ripstop
