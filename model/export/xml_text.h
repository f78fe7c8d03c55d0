// Text as it stands in XML, between tags and within quotation marks.
#pragma once

#include <string>
#include <string_view>

namespace ripstop {

inline std::string xmlText(std::string_view text)
{
    std::string escaped;
    for (const char c : text)
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    return escaped;
}

} // namespace ripstop
