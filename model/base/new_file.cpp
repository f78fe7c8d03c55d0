// In order: names of files under way, and whose they are; the stream into an open file, which
// remembers why a write failed; bringing a file into its place; and NewFile, which puts them
// together.
//
// A process is known by its number and by the machine that the number counts on: folders may be
// shared by machines and by containers, so a name carries a hash of both, and files of others are
// left alone.
#include "base/new_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view partEnding = ".part";

// --- whose a file is -----------------------------------------------------------------------------

// Eight digits for what a process number counts on: the machine, and the container on it.
const std::string& hostMark()
{
    static const std::string mark = [] {
        std::array<char, 256> host{};
        ::gethostname(host.data(), host.size() - 1);
        std::error_code none;
        const std::string name = host.data() + fs::read_symlink("/proc/self/ns/pid", none).string();
        std::uint32_t hash = 2166136261u; // FNV-1a, the same in every build
        for (const char c : name)
            hash = (hash ^ std::uint8_t(c)) * 16777619u;
        std::array<char, 9> digits{};
        std::snprintf(digits.data(), digits.size(), "%08x", unsigned(hash));
        return std::string(digits.data());
    }();
    return mark;
}

// Takes a whole number off the front.
std::optional<long> number(std::string_view& text)
{
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || value < 0)
        return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return value;
}

// The process of this machine that a file under way is named after; nothing for other files.
std::optional<pid_t> ownerOf(std::string_view name, std::string_view ending)
{
    if (!name.ends_with(ending))
        return std::nullopt;
    name.remove_suffix(ending.size());
    const auto dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0)
        return std::nullopt;
    std::string_view mark = name.substr(dot + 1);
    const auto process = number(mark);
    if (!process || !mark.starts_with('-'))
        return std::nullopt;
    mark.remove_prefix(1);
    if (!number(mark) || !mark.starts_with('-') || mark.substr(1) != hostMark())
        return std::nullopt;
    return pid_t(*process);
}

bool lives(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

fs::path folderOf(const fs::path& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// Removes what dead processes have left in a folder, of one target where one is named.
void removeLeftoversOf(const fs::path& folder, std::string_view ending, std::string_view target)
{
    std::error_code error;
    std::vector<fs::path> dead; // removed when the list is read
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const auto owner = ownerOf(name, ending);
        if (owner && name.starts_with(target) && *owner != ::getpid() && !lives(*owner))
            dead.push_back(entry->path());
    }
    for (const fs::path& file : dead)
        fs::remove_all(file, error);
}

// --- an open file --------------------------------------------------------------------------------

// A stream into an open file that remembers why a write failed.
class FileBuffer final : public std::streambuf
{
public:
    explicit FileBuffer(int handle)
        : m_handle(handle)
        , m_bytes(std::size_t(1) << 16)
    {
        setp(m_bytes.data(), m_bytes.data() + m_bytes.size());
    }
    FileBuffer(const FileBuffer&) = delete;
    FileBuffer& operator=(const FileBuffer&) = delete;
    ~FileBuffer() override { close(); }

    int handle() const { return m_handle; }
    int error() const { return m_error; }

    // What a full disk has kept back may come out only now.
    bool close()
    {
        sync();
        if (m_handle >= 0 && ::close(std::exchange(m_handle, -1)) != 0 && m_error == 0)
            m_error = errno;
        return m_error == 0;
    }

protected:
    int overflow(int c) override
    {
        if (sync() != 0)
            return traits_type::eof();
        if (c != traits_type::eof())
            sputc(char(c));
        return traits_type::not_eof(c);
    }

    int sync() override
    {
        for (const char* from = pbase(); from < pptr() && m_error == 0;) {
            const ssize_t count = ::write(m_handle, from, std::size_t(pptr() - from));
            if (count >= 0)
                from += count;
            else if (errno != EINTR)
                m_error = errno;
        }
        setp(m_bytes.data(), m_bytes.data() + m_bytes.size());
        return m_error == 0 ? 0 : -1;
    }

private:
    int m_handle;
    int m_error = 0;
    std::vector<char> m_bytes;
};

Message reason(int error)
{
    return error != 0 ? Message::verbatim(std::strerror(error)) : Message("unknown error");
}

Failure notSaved(const fs::path& file, const Message& why)
{
    return Failure("%1 was not saved: %2; make room or choose another folder.", file.string(), why);
}

std::optional<Failure> whyNoFolder(const fs::path& file)
{
    std::error_code error;
    if (fs::is_directory(folderOf(file), error))
        return std::nullopt;
    return Failure("%1 cannot be written: there is no folder %2; make it or choose another.",
                   file.string(), folderOf(file).string());
}

// Brings what was written onto the disk before a rename makes it count.
bool bringToDisk(int handle)
{
    return ::fsync(handle) == 0 || errno == EINVAL || errno == EROFS; // not every file system can
}

bool bringToDisk(const fs::path& file)
{
    const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0)
        return false;
    const bool done = bringToDisk(handle);
    ::close(handle);
    return done;
}

// The handle that standard output or standard error has, if that is what the path leads to. The
// shell may have opened a file for it, which must not be replaced under its feet.
std::optional<int> standardOutput(const fs::path& file)
{
    struct stat there
    {
    }, own{};
    if (::stat(file.c_str(), &there) != 0)
        return std::nullopt;
    for (const int handle : {STDOUT_FILENO, STDERR_FILENO})
        if (::fstat(handle, &own) == 0 && own.st_dev == there.st_dev && own.st_ino == there.st_ino)
            return handle;
    return std::nullopt;
}

// A handle for what stays where it is, or -1.
int openInPlace(const fs::path& file)
{
    if (const auto own = standardOutput(file)) {
        std::cout.flush(); // what was said before comes first
        return ::dup(*own);
    }
    return ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
}

} // namespace

bool isDevice(const fs::path& file)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::optional<Failure> unwritable(const fs::path& file)
{
    std::error_code error;
    if (auto failure = whyNoFolder(file))
        return failure;
    const fs::path folder = folderOf(file);
    if (fs::is_directory(file, error))
        return Failure("%1 is a folder; name a file in it.", file.string());
    errno = 0;
    const bool staysInPlace = isDevice(file) || standardOutput(file);
    if ((fs::exists(file, error) && ::access(file.c_str(), W_OK) != 0)
        || (!staysInPlace && ::access(folder.c_str(), W_OK) != 0))
        return Failure("%1 cannot be written: %2; choose another folder.", file.string(),
                       reason(errno));
    return std::nullopt;
}

fs::path partBeside(const fs::path& target, std::string_view ending)
{
    static std::atomic<int> count = 0;
    constexpr std::size_t longest = 180; // bytes; file systems take 255
    std::string name = target.filename().string().substr(0, longest);
    name.append(".").append(std::to_string(::getpid()));
    name.append("-").append(std::to_string(count++)).append("-").append(hostMark());
    return target.parent_path() / name.append(partEnding).append(ending);
}

bool makeEmpty(const fs::path& file)
{
    const int handle = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return handle >= 0 && ::close(handle) == 0;
}

std::optional<Message> takePlace(const fs::path& written, const fs::path& target, Flush flush)
{
    std::error_code error;
    if (const fs::file_status old = fs::status(target, error); fs::exists(old))
        fs::permissions(written, old.permissions(), error);
    errno = 0;
    if (flush == Flush::ToDisk && !bringToDisk(written))
        return reason(errno);
    fs::rename(written, target, error);
    if (error)
        return Message::verbatim(error.message());
    if (flush == Flush::ToDisk)
        bringToDisk(folderOf(target)); // the new name; the old one would be whole too
    return std::nullopt;
}

bool swapped(const fs::path& a, const fs::path& b)
{
#ifdef RENAME_EXCHANGE
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
    return false;
#endif
}

void removeLeftovers(const fs::path& folder) { removeLeftoversOf(folder, partEnding, {}); }

// --- NewFile -------------------------------------------------------------------------------------

class NewFile::Private
{
public:
    Private(fs::path named, fs::path meant, fs::path beside, int handle)
        : asked(std::move(named))
        , target(std::move(meant))
        , written(std::move(beside))
        , buffer(handle)
        , out(&buffer)
    {}
    ~Private()
    {
        std::error_code ignored;
        buffer.close();
        if (!written.empty())
            fs::remove(written, ignored);
    }

    bool isKept() const { return written.extension() != partEnding; }

    fs::path asked;   // as it was named
    fs::path target;  // behind symbolic links
    fs::path written; // empty where the target is written as it is
    FileBuffer buffer;
    std::ostream out;
};

NewFile::NewFile(std::unique_ptr<Private> made)
    : d(std::move(made))
{}
NewFile::NewFile(NewFile&&) noexcept = default;
NewFile& NewFile::operator=(NewFile&&) noexcept = default;
NewFile::~NewFile() = default;

Result<NewFile> NewFile::open(const fs::path& target)
{
    if (isDevice(target) || standardOutput(target)) {
        const int handle = openInPlace(target);
        if (handle < 0)
            return notSaved(target, reason(errno));
        return NewFile(std::make_unique<Private>(target, target, fs::path(), handle));
    }
    if (auto failure = whyNoFolder(target))
        return *failure;
    std::error_code error;
    if (fs::is_directory(target, error))
        return notSaved(target, Message("it is a folder"));
    errno = 0;
    if (fs::exists(target, error) && ::access(target.c_str(), W_OK) != 0)
        return notSaved(target, reason(errno)); // a rename would not ask
    const fs::path real =
        fs::is_symlink(target, error) ? fs::weakly_canonical(target, error) : target;
    removeLeftovers(folderOf(real));
    const fs::path written = partBeside(real);
    const int handle = ::open(written.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (handle < 0)
        return notSaved(target, reason(errno));
    return NewFile(std::make_unique<Private>(target, real, written, handle));
}

Result<NewFile> NewFile::openToKeep(const fs::path& target)
{
    Result<NewFile> file = open(target);
    if (!file || file->d->written.empty())
        return file;
    const fs::path kept = partBeside(file->d->target, target.extension().string());
    std::error_code error;
    fs::rename(file->d->written, kept, error);
    if (error)
        return notSaved(target, Message::verbatim(error.message()));
    file->d->written = kept;
    return file;
}

std::ostream& NewFile::out() { return d->out; }

const fs::path& NewFile::written() const { return d->written; }

std::optional<Failure> NewFile::commit(Flush flush)
{
    d->out.flush();
    if (!d->buffer.close() || !d->out)
        return notSaved(d->asked, reason(d->buffer.error()));
    if (d->written.empty())
        return std::nullopt;
    const bool wasKept = d->isKept();
    if (const auto why = takePlace(d->written, d->target, flush))
        return notSaved(d->asked, *why);
    d->written.clear();
    if (wasKept)
        removeLeftoversOf(folderOf(d->target),
                          std::string(partEnding) + d->target.extension().string(),
                          d->target.filename().string() + ".");
    return std::nullopt;
}

} // namespace ripstop
