#include "io/json_events.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace ripstop {
namespace {

using nlohmann::json;

// Reads characters and lets the handler see how far the parser has come.
class Cursor
{
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Cursor(const char* at, std::size_t* consumed)
        : m_at(at)
        , m_consumed(consumed)
    {}

    reference operator*() const { return *m_at; }
    Cursor& operator++()
    {
        ++m_at;
        ++*m_consumed;
        return *this;
    }
    friend bool operator==(const Cursor& a, const Cursor& b) { return a.m_at == b.m_at; }
    friend bool operator!=(const Cursor& a, const Cursor& b) { return a.m_at != b.m_at; }

private:
    const char* m_at;
    std::size_t* m_consumed;
};

// The word in which the parser stopped, in lower case.
std::string wordBefore(std::string_view text, std::size_t end)
{
    constexpr std::string_view letters = "+-abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    std::size_t first = end > 0 ? end - 1 : 0;
    while (first > 0 && letters.find(text[first - 1]) != std::string_view::npos)
        --first;
    constexpr std::size_t longest = 10;
    std::string word(text.substr(first, longest));
    word.resize(std::min(word.size(), word.find_first_not_of(letters)));
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 'a' - 'A') : c; });
    return word;
}

// What is wrong with a text that the parser gave up at `end`, and what to do.
std::string explanation(std::string_view text, std::size_t end, std::string_view what)
{
    const std::string word = wordBefore(text, end);
    const std::string_view name = std::string_view(word).substr(word.find_first_not_of("+-") == 1);
    if (name == "nan" || name == "inf" || name == "infinity")
        return "must be a finite number, not " + word;
    if (what.find("number overflow") != std::string_view::npos)
        return "must be a finite number; this one is too large for a computer";
    if (end > 0 && text[end - 1] == '\0')
        return "is followed by zero bytes: the file is damaged, restore it from a copy";

    // "[json...] parse error at line 1, column 2: syntax error while parsing value - WHAT"
    if (const auto dash = what.find(" - "); dash != std::string_view::npos)
        what.remove_prefix(dash + 3);
    constexpr std::size_t longest = 200;
    return "is not JSON (" + std::string(what.substr(0, longest))
           + "); mend the text here, or restore the file from a copy";
}

// What nlohmann::json reports, by the names that it asks for.
struct Handler
{
    using Type = JsonEvent::Type;

    std::string_view source;
    const JsonVisitor& visit;
    const std::size_t& end;

    bool tell(Type type) const { return visit({.type = type, .end = end}); }
    bool tellNumber(double number) const
    {
        return visit({.type = Type::Number, .number = number, .end = end});
    }
    bool tellText(Type type, std::string_view text) const
    {
        return visit({.type = type, .text = text, .end = end});
    }

    // NOLINTBEGIN(readability-identifier-naming)
    bool null() { return tell(Type::Null); }
    bool boolean(bool value)
    {
        return visit({.type = Type::Boolean, .boolean = value, .end = end});
    }
    bool number_integer(json::number_integer_t value) { return tellNumber(double(value)); }
    bool number_unsigned(json::number_unsigned_t value) { return tellNumber(double(value)); }
    bool number_float(double value, const std::string&) { return tellNumber(value); }
    bool string(std::string& value) { return tellText(Type::Text, value); }
    bool binary(json::binary_t&) { return false; } // never in a text
    bool start_object(std::size_t) { return tell(Type::BeginObject); }
    bool key(std::string& value) { return tellText(Type::Key, value); }
    bool end_object() { return tell(Type::EndObject); }
    bool start_array(std::size_t) { return tell(Type::BeginArray); }
    bool end_array() { return tell(Type::EndArray); }

    bool parse_error(std::size_t, const std::string&, const json::exception& error)
    {
        tellText(Type::Error, explanation(source, end, error.what()));
        return false;
    }
    // NOLINTEND(readability-identifier-naming)
};

} // namespace

void walkJson(std::string_view text, std::size_t begin, bool whole, const JsonVisitor& visit)
{
    std::size_t consumed = begin;
    Handler handler{text, visit, consumed};
    json::sax_parse(Cursor(text.data() + begin, &consumed),
                    Cursor(text.data() + text.size(), &consumed), &handler,
                    nlohmann::detail::input_format_t::json, whole);
}

std::string_view numberText(std::string_view text, std::size_t end)
{
    constexpr std::string_view numeric = "+-.0123456789Ee";
    while (end > 0 && numeric.find(text[end - 1]) == std::string_view::npos)
        --end;
    std::size_t begin = end;
    while (begin > 0 && numeric.find(text[begin - 1]) != std::string_view::npos)
        --begin;
    return text.substr(begin, end - begin);
}

} // namespace ripstop
