// How a file comes to be: whole or not at all.
//
// What will be TARGET is written beside it as TARGET.PID-NUMBER-HOST.part, brought onto the disk
// and renamed, so that whoever looks finds the old content or the new one whole, whenever the
// program or the machine ends. The name is unique, so that two writers of one target do not meet.
// It also says whose file it is: what a process has left that no longer lives is removed by the
// next one that writes into the folder. All that writes files goes through this.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string_view>

namespace ripstop {

// Waiting for the disk takes some milliseconds: worth it for a design, not for each file of a
// series.
enum class Flush { ToDisk, Later };

// Whether something is there that no file may take the place of: a device or a pipe.
bool isDevice(const std::filesystem::path& file);

// Why a file cannot be written: its folder is missing, or it or its folder is protected. For long
// work that ends in writing it; nothing when it can be, as far as can be known beforehand.
std::optional<Failure> unwritable(const std::filesystem::path& file);

// One file under way, which is removed unless it is committed.
class NewFile
{
public:
    // Devices, pipes and what standard output goes to are written as they are, and stay. Symbolic
    // links are followed.
    static Result<NewFile> open(const std::filesystem::path& target);

    // The same, for what is worth having when the process is killed: the name ends as that of the
    // target, and only a whole file of that target takes it away.
    static Result<NewFile> openToKeep(const std::filesystem::path& target);

    NewFile(NewFile&&) noexcept;
    NewFile& operator=(NewFile&&) noexcept;
    ~NewFile();

    std::ostream& out();
    const std::filesystem::path& written() const; // where it is until then

    // Takes the place of the target, with the permissions of the file that was there.
    std::optional<Failure> commit(Flush flush = Flush::ToDisk);

private:
    class Private;
    explicit NewFile(std::unique_ptr<Private> made);

    std::unique_ptr<Private> d;
};

// --- for files and folders that others write ----------------------------------------------------

// A name beside the target that no process has used. Nothing is made.
std::filesystem::path partBeside(const std::filesystem::path& target, std::string_view ending = {});

// Makes an empty file of that name; whether there was none.
bool makeEmpty(const std::filesystem::path& file);

// Gives the file that was written for it to the target. The reason why that fails, or nothing.
std::optional<Message> takePlace(const std::filesystem::path& written,
                                 const std::filesystem::path& target, Flush flush);

// Has two folders change places in one go; false where the file system cannot.
bool swapped(const std::filesystem::path& a, const std::filesystem::path& b);

// Removes what processes that no longer live have left in the folder.
void removeLeftovers(const std::filesystem::path& folder);

} // namespace ripstop
