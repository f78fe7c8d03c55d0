#include "base/hash_text.h"

#include <cstdio>

namespace ripstop {

std::string hashText(std::uint64_t hash)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

} // namespace ripstop
