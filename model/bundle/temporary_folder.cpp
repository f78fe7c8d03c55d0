#include "bundle/temporary_folder.h"

#include "base/new_file.h"

#include <system_error>
#include <utility>

namespace ripstop {

namespace fs = std::filesystem;

Result<TemporaryFolder> TemporaryFolder::make(const fs::path& begin)
{
    std::error_code error;
    removeLeftovers(begin.has_parent_path() ? begin.parent_path() : fs::path("."));
    const fs::path name = partBeside(begin);
    if (!fs::create_directory(name, error))
        return Failure("No folder can be made beside %1: %2; make room or choose another folder.",
                       begin.string(), error.message());
    TemporaryFolder folder;
    folder.m_path = name;
    return folder;
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : m_path(std::exchange(other.m_path, {}))
{}

TemporaryFolder& TemporaryFolder::operator=(TemporaryFolder&& other) noexcept
{
    std::swap(m_path, other.m_path);
    return *this;
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code ignored;
    if (!m_path.empty())
        fs::remove_all(m_path, ignored);
}

} // namespace ripstop
