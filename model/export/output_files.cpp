// open(), write(), reserve() and scratch() note each file with a name of its own beside its target
// (base/new_file.h), so that the rename stays in one folder. makeFolder() notes new folders.
//
// commit() renames the files in the order in which they were opened and then forgets them and the
// new folders; if a rename fails, those before it stay renamed. The destructor removes what is
// still noted: scratch files, files that were not committed, and new folders if they are empty.
#include "export/output_files.h"

#include "base/new_file.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

// A file would take the place of a folder or a device.
bool isTaken(const fs::path& target)
{
    std::error_code error;
    return fs::is_directory(target, error) || isDevice(target);
}

} // namespace

Failure notWritten(const fs::path& file, const Message& why)
{
    return Failure("%1 was not written: %2; make room or choose another folder.", file.string(),
                   why);
}

Failure notWritten(const fs::path& file)
{
    return notWritten(file, errno ? Message::verbatim(std::generic_category().message(errno))
                                  : Message("the disk does not answer"));
}

std::optional<Failure> close(std::ofstream& out, const fs::path& file)
{
    if (out) // or it holds why an earlier write failed
        errno = 0;
    out.close();
    if (!out)
        return notWritten(file);
    return std::nullopt;
}

OutputFiles::~OutputFiles()
{
    std::error_code ignored;
    for (const File& file : m_files)
        fs::remove(file.written, ignored);
    for (auto folder = m_newFolders.rbegin(); folder != m_newFolders.rend(); ++folder)
        fs::remove(*folder, ignored); // only when it is empty
}

// Reading a folder takes time; once for a series is enough.
void OutputFiles::tidy(const fs::path& folder)
{
    if (std::ranges::find(m_tidied, folder) != m_tidied.end())
        return;
    m_tidied.push_back(folder);
    removeLeftovers(folder.empty() ? fs::path(".") : folder);
}

std::optional<Failure> OutputFiles::makeFolder(const fs::path& folder)
{
    std::error_code error, ignored;
    if (fs::create_directory(folder, error))
        m_newFolders.push_back(folder);
    if (fs::is_directory(folder, ignored))
        return std::nullopt;
    return Failure("The folder %1 cannot be made: %2; choose another target.", folder.string(),
                   error ? Message::verbatim(error.message()) : Message("a file has that name"));
}

Result<std::ofstream> OutputFiles::open(const fs::path& target)
{
    if (isTaken(target))
        return Failure("%1 is a folder or a device; name a file.", target.string());
    if (auto failure = unwritable(target))
        return *failure;
    tidy(target.parent_path());
    const fs::path written = partBeside(target);
    errno = 0;
    if (!makeEmpty(written))
        return notWritten(target);
    m_files.push_back({written, target});
    std::ofstream out(written, std::ios::binary);
    if (!out)
        return notWritten(target);
    return out;
}

std::optional<Failure> OutputFiles::write(const fs::path& target, std::string_view content)
{
    Result<std::ofstream> out = open(target);
    if (!out)
        return out.failure();
    out->write(content.data(), std::streamsize(content.size()));
    return close(*out, target);
}

fs::path OutputFiles::reserve(const fs::path& target)
{
    tidy(target.parent_path());
    m_files.push_back({partBeside(target), target});
    return m_files.back().written;
}

Result<std::fstream> OutputFiles::scratch(const fs::path& besides)
{
    tidy(besides.parent_path());
    const fs::path written = partBeside(besides);
    errno = 0;
    if (!makeEmpty(written))
        return notWritten(besides);
    m_files.push_back({written, {}});
    std::fstream file(written, std::ios::binary | std::ios::in | std::ios::out);
    if (!file)
        return notWritten(besides);
    return file;
}

std::optional<Failure> OutputFiles::commit()
{
    for (const File& file : m_files) {
        if (file.target.empty())
            continue;
        if (isTaken(file.target))
            return notWritten(file.target, Message("it is a folder or a device"));
        if (const auto why = takePlace(file.written, file.target, Flush::Later))
            return notWritten(file.target, *why);
    }
    std::erase_if(m_files, [](const File& file) { return !file.target.empty(); });
    m_newFolders.clear();
    return std::nullopt;
}

} // namespace ripstop
