// ASCII in lower case, whatever the locale: how endings of files and words of formats are compared.
#pragma once

#include <algorithm>
#include <string>

namespace ripstop {

inline std::string lowerCase(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

} // namespace ripstop
