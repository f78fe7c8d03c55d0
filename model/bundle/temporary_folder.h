// A folder for work on the way, which is removed with all that is in it. Making one can fail, and
// the failure says why.
#pragma once

#include "base/result.h"

#include <filesystem>

namespace ripstop {

// A folder that goes with all that is in it, unless it was moved away.
class TemporaryFolder
{
public:
    // A new one beside `begin`, named as other things under way are (base/new_file.h).
    static Result<TemporaryFolder> make(const std::filesystem::path& begin);

    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder& operator=(TemporaryFolder&& other) noexcept;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return m_path; }

private:
    TemporaryFolder() = default;

    std::filesystem::path m_path;
};

} // namespace ripstop
