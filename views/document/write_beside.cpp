#include "document/write_beside.h"

#include "base/new_file.h"

namespace ripstop {

bool writeBeside(const QString& target, const std::function<bool(const QString& file)>& write)
{
    const std::filesystem::path place(target.toStdU16String());
    if (isDevice(place))
        return write(target);
    removeLeftovers(place.has_parent_path() ? place.parent_path() : std::filesystem::path("."));
    const std::filesystem::path written = partBeside(place);
    if (write(QString::fromStdU16String(written.u16string()))
        && !takePlace(written, place, Flush::ToDisk))
        return true;
    std::error_code ignored;
    std::filesystem::remove(written, ignored);
    return false;
}

} // namespace ripstop
