#include "io/json_events.h"

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace ripstop {
namespace {

constexpr const char* tooLarge = "must be a finite number; this one is too large for a computer";

// The text, as the parser wants to read it: zero at the end.
class Characters
{
public:
    // NOLINTBEGIN(readability-identifier-naming)
    using Ch = char;

    explicit Characters(std::string_view text, std::size_t begin)
        : m_text(text)
        , m_at(begin)
    {}

    char Peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
    char Take() { return m_at < m_text.size() ? m_text[m_at++] : '\0'; }
    std::size_t Tell() const { return m_at; }

    // Asked for by the parser, and called only where it changes a text in place.
    char* PutBegin() { return nullptr; }
    void Put(char) {}
    void Flush() {}
    std::size_t PutEnd(char*) { return 0; }
    // NOLINTEND(readability-identifier-naming)

private:
    std::string_view m_text;
    std::size_t m_at;
};

// The word at a place, in lower case.
std::string wordAt(std::string_view text, std::size_t place)
{
    constexpr std::string_view letters = "+-abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    std::size_t first = std::min(place, text.size());
    while (first > 0 && letters.find(text[first - 1]) != std::string_view::npos)
        --first;
    constexpr std::size_t longest = 10;
    std::string word(text.substr(first, longest));
    word.resize(std::min(word.size(), word.find_first_not_of(letters)));
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 'a' - 'A') : c; });
    return word;
}

// What is wrong with a text that the parser gave up at `place`, and what to do.
std::string explanation(std::string_view text, std::size_t place, rapidjson::ParseErrorCode code)
{
    const std::string word = wordAt(text, place);
    const std::string_view name = std::string_view(word).substr(word.find_first_not_of("+-") == 1);
    if (name == "nan" || name == "inf" || name == "infinity")
        return "must be a finite number, not " + word;
    if (code == rapidjson::kParseErrorNumberTooBig)
        return tooLarge;
    if (place < text.size() && text[place] == '\0')
        return "is followed by zero bytes: the file is damaged, restore it from a copy";

    std::string what = rapidjson::GetParseError_En(code);
    if (code == rapidjson::kParseErrorStringInvalidEncoding)
        what = "A string has a line break or a tab in it, or is not UTF-8";
    if (what.ends_with('.'))
        what.pop_back();
    return "is not JSON (" + what + "); mend the text here, or restore the file from a copy";
}

// What RapidJSON reports, by the names that it asks for.
class Handler
{
public:
    using Type = JsonEvent::Type;

    Handler(const Characters& characters, const JsonVisitor& visit)
        : m_characters(characters)
        , m_visit(visit)
    {}

    bool tell(Type type, std::string_view text = {}) const
    {
        return m_visit({.type = type, .text = text, .end = m_characters.Tell()});
    }

    // NOLINTBEGIN(readability-identifier-naming)
    using Ch = char;
    using Size = rapidjson::SizeType;

    bool Null() { return tell(Type::Null); }
    bool Bool(bool value)
    {
        return m_visit({.type = Type::Boolean, .boolean = value, .end = m_characters.Tell()});
    }
    // Read here, since the parser does not round every decimal to the nearest double.
    bool RawNumber(const char* begin, Size length, bool)
    {
        double number = 0.0;
        if (std::from_chars(begin, begin + length, number).ec == std::errc::result_out_of_range)
            number = std::strtod(std::string(begin, length).c_str(), nullptr); // huge or tiny
        if (!std::isfinite(number)) {
            tell(Type::Error, tooLarge);
            return false;
        }
        return m_visit({.type = Type::Number, .number = number, .end = m_characters.Tell()});
    }
    bool String(const char* begin, Size length, bool) { return tell(Type::Text, {begin, length}); }
    bool Key(const char* begin, Size length, bool) { return tell(Type::Key, {begin, length}); }
    // Told of when the parser is at a bracket, and not behind it.
    bool StartObject() { return tellBracket(Type::BeginObject); }
    bool EndObject(Size) { return tellBracket(Type::EndObject); }
    bool StartArray() { return tellBracket(Type::BeginArray); }
    bool EndArray(Size) { return tellBracket(Type::EndArray); }

    // Numbers come as texts.
    bool Int(int) { return false; }
    bool Uint(unsigned) { return false; }
    bool Int64(std::int64_t) { return false; }
    bool Uint64(std::uint64_t) { return false; }
    bool Double(double) { return false; }
    // NOLINTEND(readability-identifier-naming)

private:
    bool tellBracket(Type type) const
    {
        return m_visit({.type = type, .end = m_characters.Tell() + 1});
    }

    const Characters& m_characters;
    const JsonVisitor& m_visit;
};

} // namespace

void walkJson(std::string_view text, std::size_t begin, bool whole, const JsonVisitor& visit)
{
    constexpr unsigned flags = rapidjson::kParseIterativeFlag | rapidjson::kParseStopWhenDoneFlag
                               | rapidjson::kParseNumbersAsStringsFlag
                               | rapidjson::kParseValidateEncodingFlag;
    Characters characters(text, begin);
    Handler handler(characters, visit);
    rapidjson::Reader reader;
    const rapidjson::ParseResult result = reader.Parse<flags>(characters, handler);
    const auto fail = [&](std::size_t place, rapidjson::ParseErrorCode code) {
        visit({.type = JsonEvent::Type::Error,
               .text = explanation(text, place, code),
               .end = std::min(place + 1, text.size())});
    };
    if (result.IsError() && result.Code() != rapidjson::kParseErrorTermination)
        fail(result.Offset(), result.Code());
    if (result.IsError() || !whole)
        return;
    const std::size_t rest = text.find_first_not_of(" \t\r\n", characters.Tell());
    if (rest != std::string_view::npos)
        fail(rest, rapidjson::kParseErrorDocumentRootNotSingular);
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
