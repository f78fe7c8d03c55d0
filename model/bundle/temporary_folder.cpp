#include "bundle/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace ripstop {

namespace fs = std::filesystem;

Result<TemporaryFolder> TemporaryFolder::make(const fs::path& begin)
{
    std::string name = begin.string() + ".XXXXXX";
    if (!::mkdtemp(name.data()))
        return Failure("No folder can be made beside %1: %2; make room or choose another folder.",
                       begin.string(), std::generic_category().message(errno));
    std::error_code ignored; // mkdtemp() makes it for its owner alone
    fs::permissions(name,
                    fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read
                        | fs::perms::others_exec,
                    fs::perm_options::add, ignored);
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
