#include "mesh_reader/bounded_files.h"

#include "mesh_reader/process_limits.h"
#include "shapes/mesh_process.h"

#include <filesystem>
#include <string_view>

namespace ripstop {

Assimp::IOStream* BoundedFiles::Open(const char* file, const char* mode)
{
    std::error_code error;
    const bool isToRead = std::string_view(mode).starts_with('r')
                          && std::string_view(mode).find('+') == std::string_view::npos;
    if (!isToRead || !std::filesystem::is_regular_file(file, error))
        return nullptr;
    if (m_opened.insert(file).second) { // each importer looks whether it is of its format
        const std::uint64_t size = std::filesystem::file_size(file, error);
        m_areTooLarge = m_areTooLarge || error || size > ReadLimits::mostBytes - m_bytes;
        if (!m_areTooLarge) {
            m_bytes += size;
            limitProcess(m_bytes);
        }
    }
    return m_areTooLarge ? nullptr : DefaultIOSystem::Open(file, mode);
}

} // namespace ripstop
