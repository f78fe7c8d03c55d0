#include "recording/spill_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown error"; }

} // namespace

std::optional<Failure> SpillFile::open()
{
    static std::atomic<int> count = 0;
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error)
        return Failure{"there is no folder for temporary files; set TMPDIR to one"};
    for (int attempt = 0; attempt < 1000 && !m_file; ++attempt) {
        std::string name = "ripstop-run-";
        name.append(std::to_string(std::hash<std::string>()(folder.string()) & 0xffffu));
        name.append("-").append(std::to_string(reinterpret_cast<std::uintptr_t>(this)));
        name.append("-").append(std::to_string(count++));
        const fs::path file = folder / name;
        m_file.reset(std::fopen(file.c_str(), "w+bx")); // fails where there is one of that name
        if (m_file)
            fs::remove(file, error); // what is open stays until it is closed
        else if (errno != EEXIST)
            break;
    }
    if (!m_file)
        return Failure("no temporary file can be made in %1: %2", folder.string(), reason());
    return std::nullopt;
}

Result<std::size_t> SpillFile::append(std::string_view bytes)
{
    const std::lock_guard lock(m_mutex);
    errno = 0;
    if (!m_file)
        if (auto failure = open())
            return *failure;
    const std::size_t place = m_end;
    const bool written = fseeko(m_file.get(), off_t(place), SEEK_SET) == 0
                         && std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) == bytes.size()
                         && std::fflush(m_file.get()) == 0;
    if (!written)
        return Failure("the folder for temporary files cannot take more: %1", reason());
    m_end += bytes.size();
    return place;
}

Result<std::string> SpillFile::read(std::size_t place, std::size_t size)
{
    const std::lock_guard lock(m_mutex);
    errno = 0;
    std::string bytes(size, '\0');
    if (fseeko(m_file.get(), off_t(place), SEEK_SET) != 0
        || std::fread(bytes.data(), 1, size, m_file.get()) != size)
        return Failure("a temporary file cannot be read: %1", reason());
    return bytes;
}

} // namespace ripstop
