// A picture is known by its first bytes. Its name is that of the mesh and its own, or its number
// where it has none; names are tried with numbers behind them until nothing else is there.
#include "shapes/packed_pictures.h"

#include "base/new_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

std::string_view endingOf(const std::string& bytes)
{
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"))
        return ".png";
    if (bytes.starts_with("\xff\xd8\xff"))
        return ".jpg";
    return {};
}

// Without what a name of a file may not have everywhere, and short.
std::string plainName(const std::string& name)
{
    constexpr std::size_t longest = 60;
    std::string plain = name.substr(0, longest);
    for (char& letter : plain)
        if (const auto code = static_cast<unsigned char>(letter);
            !std::isalnum(code) && letter != '-' && letter != '_')
            letter = '_';
    return plain;
}

bool holds(const fs::path& file, const std::string& bytes)
{
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) != bytes.size())
        return false;
    std::ifstream stream(file, std::ios::binary);
    return std::equal(std::istreambuf_iterator<char>(stream), {}, bytes.begin(), bytes.end());
}

} // namespace

void nameFilesBeside(const fs::path& meshFile, std::vector<PolygonMesh::PackedPicture>& pictures)
{
    std::error_code error;
    const fs::path folder = fs::absolute(meshFile, error).parent_path();
    std::set<std::string> taken;       // by pictures before
    std::map<std::string, int> number; // by name, the one that is tried next
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        PolygonMesh::PackedPicture& picture = pictures[i];
        picture.file.clear();
        const std::string ending(endingOf(picture.bytes));
        if (ending.empty())
            continue;
        const std::string own =
            picture.name.empty() ? std::to_string(i + 1) : plainName(picture.name);
        const std::string stem = (folder / meshFile.stem()).string() + "-" + own;
        int& next = number.try_emplace(stem + ending, 1).first->second;
        do {
            picture.file = stem + (next > 1 ? "-" + std::to_string(next) : "") + ending;
            ++next;
        } while (taken.contains(picture.file)
                 || (fs::exists(picture.file, error) && !holds(picture.file, picture.bytes)));
        taken.insert(picture.file);
    }
}

std::optional<Failure> unpack(const PolygonMesh::PackedPicture& picture)
{
    if (holds(picture.file, picture.bytes))
        return std::nullopt;
    std::error_code error;
    if (fs::exists(picture.file, error))
        return Failure("%1 has come since the mesh was read, with something else in it; import the "
                       "mesh again.",
                       picture.file);
    Result<NewFile> file = NewFile::open(picture.file);
    if (!file)
        return file.failure();
    file->out().write(picture.bytes.data(), std::streamsize(picture.bytes.size()));
    return file->commit();
}

} // namespace ripstop
