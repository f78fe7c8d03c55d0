// Writes numbers and strings as JSON.
//
// Numbers go through std::to_chars, which gives the shortest text of the same bits. Strings that
// need no change, as nearly all do, are appended at once; others go through appendCharacters(),
// which finds each character by its length in UTF-8, so that broken bytes become question marks and
// whole characters pass. appendQuoted() escapes characters of one byte, and printable() blanks
// controls.
#include "io/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

bool isPlain(char c) { return c >= 0x20 && c < 0x7f && c != '"' && c != '\\'; }

// Length of the well-formed UTF-8 character at the front, 0 when there is none (RFC 3629).
std::size_t characterLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? unsigned(text[i]) & 0xff : 0u;
    };
    const unsigned first = byte(0);
    if (first < 0x80)
        return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4)
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80)
            return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) > 0x9f;
    const bool tooHigh = first == 0xf4 && byte(1) > 0x8f;
    return overlong || surrogate || tooHigh ? 0 : length;
}

void appendEscaped(std::string& text, char c)
{
    constexpr std::string_view digits = "0123456789abcdef";
    switch (c) {
    case '"':
        text += "\\\"";
        break;
    case '\\':
        text += "\\\\";
        break;
    case '\n':
        text += "\\n";
        break;
    case '\t':
        text += "\\t";
        break;
    default:
        if (c >= 0x20) {
            text += c;
        } else {
            text += "\\u00";
            text += digits[std::size_t(c) >> 4];
            text += digits[std::size_t(c) & 15];
        }
    }
}

// Calls back with each character of one byte; others are appended, and a question mark for each
// byte that is not UTF-8.
template <typename Ascii>
void appendCharacters(std::string& text, std::string_view value, const Ascii& appendAscii)
{
    while (!value.empty()) {
        const std::size_t length = characterLength(value);
        if (length == 1)
            appendAscii(value.front());
        else if (length == 0)
            text += '?';
        else
            text += value.substr(0, length);
        value.remove_prefix(std::max<std::size_t>(length, 1));
    }
}

} // namespace

void appendNumber(std::string& text, double number)
{
    if (!std::isfinite(number)) {
        text += "null";
        return;
    }
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    if (number == 0.0 && std::signbit(number))
        text += ".0"; // "-0" would be read back as a whole number, which has no negative zero
}

std::string numberText(double number)
{
    std::string text;
    appendNumber(text, number);
    return text;
}

void appendQuoted(std::string& text, std::string_view value)
{
    text += '"';
    if (std::all_of(value.begin(), value.end(), isPlain))
        text += value;
    else
        appendCharacters(text, value, [&](char c) { appendEscaped(text, c); });
    text += '"';
}

std::string printable(std::string_view value)
{
    std::string text;
    appendCharacters(text, value, [&](char c) { text += c < ' ' ? ' ' : c; });
    return text;
}

} // namespace ripstop
