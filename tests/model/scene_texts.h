// Scene files as short texts, into which tests put the lines that they are about. The lines before
// them are always the same number, so that a test can ask for the line in a message.
#pragma once

#include <QString>

namespace ripstop {

// `lines` are the lines of a list of items, the first of which is line 4.
inline QString withItems(const QString& lines)
{
    return "{\"format\": \"ripstop-scene\",\n\"version\": 1,\n\"items\": [\n" + lines + "\n]}\n";
}

// `lines` are the lines of a part with id 1, the first of which is line 5.
inline QString withPart(const QString& lines)
{
    return withItems("{\"type\": \"part\", \"id\": 1,\n" + lines + "}");
}

inline QString withParticle(const QString& members)
{
    return withPart("\"particles\": [\n{\"id\": 2, \"pinned\": true},\n{\"id\": 3, " + members
                    + "}]");
}

} // namespace ripstop
