#include "base/message.h"

#include <cstdio>

namespace ripstop {

Message Message::number(const char* pattern, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return number(std::string(text));
}

std::string Message::english() const
{
    return m_parts.empty() ? m_text
                           : said([](Kind, const std::string& english) { return english; });
}

// Fills the gaps in one pass, so that a name with a "%1" in it stays as it is.
std::string Message::said(Lookup inOther) const
{
    const std::string sentence = inOther(m_kind, m_text);
    std::string text;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const std::size_t gap = i + 1 < sentence.size() && sentence[i] == '%'
                                    ? std::size_t(sentence[i + 1] - '1')
                                    : m_parts.size();
        if (gap < m_parts.size()) {
            text += m_parts[gap].said(inOther);
            ++i;
        } else {
            text += sentence[i];
        }
    }
    return text;
}

} // namespace ripstop
