// Reading goes chunk by chunk, with a check of the first one. Writing is left to NewFile.
#include "io/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largestFile = std::size_t(4) << 30; // bytes
constexpr std::size_t chunk = std::size_t(1) << 20;

Message reason()
{
    return errno != 0 ? Message::verbatim(std::strerror(errno)) : Message("unknown error");
}

} // namespace

Result<std::string> readWholeFile(const fs::path& file, const StartCheck& check)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status))
        return Failure("%1 does not exist; check the path.", file.string());
    if (fs::is_directory(status))
        return Failure("%1 is a folder; name a file in it.", file.string());

    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return Failure("%1 cannot be opened: %2.", file.string(), reason());

    // Sizes of pipes and special files are not known beforehand.
    std::string text;
    std::size_t expected = 0;
    if (fs::is_regular_file(status)) {
        const auto size = fs::file_size(file, error);
        if (!error && size > largestFile)
            return Failure("%1 is larger than 4 GiB, too large for this program.", file.string());
        expected = error ? 0 : std::size_t(size);
    }
    for (;;) {
        const std::size_t before = text.size();
        text.resize(before + chunk);
        in.read(text.data() + before, std::streamsize(chunk));
        text.resize(before + std::size_t(in.gcount()));
        if (before == 0) {
            if (const auto refused = check(text))
                return Failure("%1, line 1: the file %2.", file.string(), *refused);
            text.reserve(expected + chunk);
        }
        if (in.bad())
            return Failure("%1 cannot be read: %2.", file.string(), reason());
        if (in.eof())
            return text;
        if (text.size() > largestFile)
            return Failure("%1 is larger than 4 GiB, too large for this program.", file.string());
    }
}

std::optional<Failure> replaceFile(const fs::path& file, std::string_view content, Flush flush)
{
    const auto write = [content](std::ostream& out) -> std::optional<Failure> {
        out.write(content.data(), std::streamsize(content.size()));
        return std::nullopt;
    };
    return replaceFile(file, WriteInto(write), flush);
}

std::optional<Failure> replaceFile(const fs::path& file, const WriteInto& write, Flush flush)
{
    Result<NewFile> made = NewFile::open(file);
    if (!made)
        return made.failure();
    if (auto failure = write(made->out()))
        return failure;
    return made->commit(flush);
}

} // namespace ripstop
