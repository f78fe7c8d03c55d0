// The files of an export, which come into their places together or not at all. Failures name the
// target and what to do.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

namespace ripstop {

// Files that come into their places together or not at all: they are written under other names
// beside their targets, and renamed when all are whole. What was not committed is removed, with
// the folders that were made for it; what a killed process left is removed (base/new_file.h).
class OutputFiles
{
public:
    OutputFiles() = default;
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;
    ~OutputFiles();

    // A folder for some of the targets, unless it is there.
    std::optional<Failure> makeFolder(const std::filesystem::path& folder);

    // For what will be `target`.
    Result<std::ofstream> open(const std::filesystem::path& target);
    std::optional<Failure> write(const std::filesystem::path& target, std::string_view content);

    // Where another program is to write what will be `target`.
    std::filesystem::path reserve(const std::filesystem::path& target);

    // For work on the way; it is removed in the end.
    Result<std::fstream> scratch(const std::filesystem::path& besides);

    std::optional<Failure> commit();

private:
    struct File
    {
        std::filesystem::path written;
        std::filesystem::path target; // empty for scratch
    };

    void tidy(const std::filesystem::path& folder);

    std::vector<File> m_files;
    std::vector<std::filesystem::path> m_tidied; // folders that leftovers were removed from
    std::vector<std::filesystem::path> m_newFolders;
};

// Why a file could not be written; without a reason, as errno has it.
Failure notWritten(const std::filesystem::path& file, const Message& why);
Failure notWritten(const std::filesystem::path& file);

// Closes it; the failure of any write, or nothing.
std::optional<Failure> close(std::ofstream& out, const std::filesystem::path& file);

} // namespace ripstop
