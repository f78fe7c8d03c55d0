// zipFolder() lists the files in sorted order and adds each with the first date that a zip can
// say, so that the same files give the same bytes; recordings and pictures are packed already and
// are stored as they are. libzip does the work only in zip_close(), which therefore carries
// progress and cancelling, and which puts the target into place in one rename. After a failure
// Discard drops the archive, so that the target stays as it was.
//
// unzip() opens the archive with libzip's check of consistency and unpacks entry by entry: the name
// must not lead out of the folder, then the content is copied in pieces of 64 KiB, so that large
// recordings need little memory. What is unpacked is bounded by the size of the archive.
#include "bundle/zip_file.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>

#include <zip.h>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

struct Discard // what was not closed changes nothing
{
    void operator()(zip_t* zip) const { zip_discard(zip); }
};
using Zip = std::unique_ptr<zip_t, Discard>;

struct CloseFile
{
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using ZipEntry = std::unique_ptr<zip_file_t, CloseFile>;

std::string textOf(int code)
{
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    return text;
}

Failure unread(const fs::path& zip, const Message& why)
{
    return Failure("%1 cannot be unpacked: %2; it is damaged or cut off, get it again.",
                   zip.string(), why);
}

Failure unwritten(const fs::path& target, const Message& why)
{
    return Failure("%1 was not written: %2; make room or choose another folder.", target.string(),
                   why);
}

std::vector<fs::path> filesUnder(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path().lexically_relative(folder));
    std::ranges::sort(files);
    return files;
}

bool add(zip_t* zip, const fs::path& file, const std::string& name)
{
    constexpr zip_int64_t whole = 0;
    zip_source_t* source = zip_source_file(zip, file.c_str(), 0, whole);
    const zip_int64_t entry =
        source ? zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (entry < 0) {
        zip_source_free(source);
        return false;
    }
    constexpr zip_uint16_t morning = 0, newYear1980 = (1 << 5) | 1; // the first that a zip can say
    zip_file_set_dostime(zip, zip_uint64_t(entry), morning, newYear1980, 0);
    if (file.extension() == ".ripstop-run" || file.extension() == ".png") // packed already
        zip_set_file_compression(zip, zip_uint64_t(entry), ZIP_CM_STORE, 0);
    return true;
}

// What may still be unpacked. Tables of probes that do not move pack best, to about a fiftieth.
struct Room
{
    static constexpr std::uint64_t atOnce = std::uint64_t(64) << 20; // bytes
    static constexpr std::uint64_t perByte = 100;                    // of the archive

    explicit Room(std::uint64_t archive)
        : left(atOnce + perByte * archive)
    {}

    std::uint64_t left; // bytes
};

bool leadsOut(const fs::path& name)
{
    return name.is_absolute() || name.empty()
           || std::ranges::find(name, fs::path("..")) != name.end();
}

std::optional<Failure> unpackEntry(zip_t* zip, zip_uint64_t number, const fs::path& archive,
                                   const fs::path& folder, Room& room)
{
    const char* said = zip_get_name(zip, number, 0);
    const fs::path name = said ? said : "";
    if (leadsOut(name))
        return unread(archive, Message("%1 leads out of it", name.string()));
    std::error_code error;
    if (name.filename().empty()) { // a folder
        fs::create_directories(folder / name, error);
        return std::nullopt;
    }
    fs::create_directories((folder / name).parent_path(), error);
    const ZipEntry entry(zip_fopen_index(zip, number, 0));
    if (!entry)
        return unread(archive, Message("%1: %2", name.string(), zip_strerror(zip)));
    std::ofstream out(folder / name, std::ios::binary | std::ios::trunc);
    std::vector<char> buffer(std::size_t(1) << 16);
    zip_int64_t count = 0;
    while ((count = zip_fread(entry.get(), buffer.data(), buffer.size())) > 0) {
        if (std::uint64_t(count) > room.left)
            return Failure("%1 was not unpacked: there is far more in it than its size allows for; "
                           "get it from whom you trust, and unpack it by hand.",
                           archive.string());
        room.left -= std::uint64_t(count);
        out.write(buffer.data(), count);
    }
    if (count < 0)
        return unread(archive, Message("%1: %2", name.string(), zip_file_strerror(entry.get())));
    out.close();
    if (!out)
        return unwritten(folder / name, Message("there is no room for what is unpacked"));
    return std::nullopt;
}

} // namespace

std::optional<Failure> zipFolder(const fs::path& folder, const std::string& top,
                                 const fs::path& target, const Progress& progress)
{
    int code = 0;
    Zip zip(zip_open(target.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!zip)
        return unwritten(target, Message::verbatim(textOf(code)));
    for (const fs::path& file : filesUnder(folder))
        if (!add(zip.get(), folder / file, (fs::path(top) / file).generic_string()))
            return unwritten(target, Message::verbatim(zip_strerror(zip.get())));

    struct Watch
    {
        const Progress& progress;
        bool cancelled = false;
    } watch{progress};
    zip_register_progress_callback_with_state(
        zip.get(), 0.01,
        [](zip_t*, double share, void* state) {
            auto& seen = *static_cast<Watch*>(state);
            seen.cancelled = seen.cancelled || !goesOn(seen.progress, share);
        },
        nullptr, &watch);
    zip_register_cancel_callback_with_state(
        zip.get(), [](zip_t*, void* state) { return int(static_cast<Watch*>(state)->cancelled); },
        nullptr, &watch);
    if (zip_close(zip.get()) != 0) // writes a file beside the target, and renames it
        return watch.cancelled ? Failure{"Cancelled."}
                               : unwritten(target, Message::verbatim(zip_strerror(zip.get())));
    (void)zip.release();
    return std::nullopt;
}

std::optional<Failure> unzip(const fs::path& zip, const fs::path& folder, const Progress& progress)
{
    int code = 0;
    const Zip archive(zip_open(zip.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
    if (!archive)
        return unread(zip, Message::verbatim(textOf(code)));
    std::error_code error;
    const std::uint64_t size = fs::file_size(zip, error);
    Room room(error ? 0 : size);
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        if (auto failure = unpackEntry(archive.get(), zip_uint64_t(i), zip, folder, room))
            return failure;
        if (!goesOn(progress, double(i + 1) / double(count)))
            return Failure{"Cancelled."};
    }
    return std::nullopt;
}

} // namespace ripstop
