// Reading goes chunk by chunk, with a check of the first one. Writing goes to a file beside the
// target, onto the disk where that is asked for, and then takes the target's place by a rename.
#include "io/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largestFile = std::size_t(4) << 30; // bytes
constexpr std::size_t chunk = std::size_t(1) << 20;

Message reason()
{
    return errno != 0 ? Message::verbatim(std::strerror(errno)) : Message("unknown error");
}

// Brings what was written onto the disk before the rename makes it count.
bool flushToDisk(const fs::path& file)
{
    const int handle = ::open(file.c_str(), O_RDONLY);
    if (handle < 0)
        return false;
    const bool done = ::fsync(handle) == 0 || errno == EINVAL; // not every file system can
    ::close(handle);
    return done;
}

// A device, a pipe: there, and nothing that another file may take the place of.
bool isSpecial(const fs::path& file)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

fs::path folderOf(const fs::path& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::optional<Failure> whyNoFolder(const fs::path& file)
{
    std::error_code error;
    if (fs::is_directory(folderOf(file), error))
        return std::nullopt;
    return Failure("%1 cannot be written: there is no folder %2; make it or choose another.",
                   file.string(), folderOf(file).string());
}

Failure notSaved(const fs::path& file, const Message& why)
{
    return Failure("%1 was not saved: %2; make room or choose another folder.", file.string(), why);
}

std::optional<Failure> writeInPlace(const fs::path& file, const WriteInto& write)
{
    errno = 0;
    std::ofstream out(file, std::ios::binary);
    if (auto failure = write(out))
        return failure;
    out.close();
    return out ? std::nullopt : std::optional(notSaved(file, reason()));
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

std::optional<Failure> unwritable(const fs::path& file)
{
    if (auto failure = whyNoFolder(file))
        return failure;
    std::error_code error;
    const fs::path folder = folderOf(file);
    if (fs::is_directory(file, error))
        return Failure("%1 is a folder; name a file in it.", file.string());
    errno = 0;
    if (::access((isSpecial(file) ? file : folder).c_str(), W_OK) != 0)
        return Failure("%1 cannot be written: %2; choose another folder.", file.string(), reason());
    return std::nullopt;
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
    std::error_code error;
    const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    if (isSpecial(target))
        return writeInPlace(file, write);
    fs::path temporary = target;
    temporary.concat(".").concat(std::to_string(::getpid())).concat(".saving");

    const auto failed = [&](const Message& why) {
        fs::remove(temporary, error);
        return notSaved(file, why);
    };
    if (fs::is_directory(target, error))
        return failed(Message("it is a folder"));
    if (auto failure = whyNoFolder(target))
        return failure;

    errno = 0;
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (auto failure = write(out)) {
        fs::remove(temporary, error);
        return failure;
    }
    out.close();
    if (!out || (flush == Flush::ToDisk && !flushToDisk(temporary)))
        return failed(reason());

    if (const fs::file_status old = fs::status(target, error); fs::exists(old))
        fs::permissions(temporary, old.permissions(), error);
    fs::rename(temporary, target, error);
    if (error)
        return failed(Message::verbatim(error.message()));
    return std::nullopt;
}

} // namespace ripstop
