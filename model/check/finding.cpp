#include "check/finding.h"

#include <cctype>

namespace ripstop {

Message subjectOf(Kind kind, Id id)
{
    std::string name(kindName(kind));
    name[0] = char(std::toupper(name[0]));
    return id == settingsId ? Message::word(name)
                            : Message("%1 %2", Message::word(name), std::uint32_t(id));
}

} // namespace ripstop
