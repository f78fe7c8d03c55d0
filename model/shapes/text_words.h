// Words, numbers and lines of text files. The readers of OBJ, OFF and PLY take them from the front
// of a view into the text, so that nothing is copied; numbers have a point in every locale.
#pragma once

#include <charconv>
#include <string_view>

namespace ripstop {

inline bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// Takes the next word off the front of a line; empty at its end.
inline std::string_view takeWord(std::string_view& line)
{
    std::size_t begin = 0;
    while (begin < line.size() && isBlank(line[begin]))
        ++begin;
    std::size_t end = begin;
    while (end < line.size() && !isBlank(line[end]))
        ++end;
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

// Takes the next line off the front of a text, without its line end.
inline std::string_view takePlainLine(std::string_view& text)
{
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

// Reads the whole word as a number; false when it is none. A plus in front is allowed.
template <typename Number>
bool readNumber(std::string_view word, Number& number)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return !word.empty() && error == std::errc() && end == word.data() + word.size();
}

} // namespace ripstop
