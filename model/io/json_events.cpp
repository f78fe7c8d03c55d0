// Walks a JSON text with RapidJSON and tells a visitor of what comes.
//
// walkJson() lets the parser run iteratively, so that nesting costs no stack, and has it leave
// numbers as text, since it does not round each of them to the nearest double. Handler reads these
// and turns the calls of the parser into events with their ends. When the parser gives up,
// explanation() looks at the text around that place for the usual causes (NaN, infinity, zero
// bytes, line breaks in strings) before it quotes the parser. A walk that the visitor ends is no
// error.
#include "io/json_events.h"

#include <rapidjson/error/en.h>
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace ripstop {
namespace {

constexpr const char* tooLarge = "must be a finite number; this one is too large for a computer";

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
class Handler : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, Handler>
{
public:
    using Type = JsonEvent::Type;
    using Size = rapidjson::SizeType;

    // `begin` is where the stream begins in the text.
    Handler(const rapidjson::MemoryStream& stream, std::size_t begin, const JsonVisitor& visit)
        : m_stream(stream)
        , m_begin(begin)
        , m_visit(visit)
    {}

    std::size_t place() const { return m_begin + m_stream.Tell(); }
    bool tell(Type type, std::string_view text = {}) const
    {
        return m_visit({.type = type, .text = text, .end = place()});
    }

    // NOLINTBEGIN(readability-identifier-naming)
    bool Null() { return tell(Type::Null); }
    bool Bool(bool value)
    {
        return m_visit({.type = Type::Boolean, .boolean = value, .end = place()});
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
        return m_visit({.type = Type::Number, .number = number, .end = place()});
    }
    bool String(const char* begin, Size length, bool) { return tell(Type::Text, {begin, length}); }
    bool Key(const char* begin, Size length, bool) { return tell(Type::Key, {begin, length}); }
    // Told of when the parser is at a bracket, and not behind it.
    bool StartObject() { return tellBracket(Type::BeginObject); }
    bool EndObject(Size) { return tellBracket(Type::EndObject); }
    bool StartArray() { return tellBracket(Type::BeginArray); }
    bool EndArray(Size) { return tellBracket(Type::EndArray); }
    // NOLINTEND(readability-identifier-naming)

private:
    bool tellBracket(Type type) const { return m_visit({.type = type, .end = place() + 1}); }

    const rapidjson::MemoryStream& m_stream;
    std::size_t m_begin;
    const JsonVisitor& m_visit;
};

} // namespace

void walkJson(std::string_view text, std::size_t begin, bool whole, const JsonVisitor& visit)
{
    constexpr unsigned flags = rapidjson::kParseIterativeFlag | rapidjson::kParseStopWhenDoneFlag
                               | rapidjson::kParseNumbersAsStringsFlag
                               | rapidjson::kParseValidateEncodingFlag;
    rapidjson::MemoryStream stream(text.data() + begin, text.size() - begin);
    Handler handler(stream, begin, visit);
    rapidjson::Reader reader;
    const rapidjson::ParseResult result = reader.Parse<flags>(stream, handler);
    const auto fail = [&](std::size_t place, rapidjson::ParseErrorCode code) {
        visit({.type = JsonEvent::Type::Error,
               .text = explanation(text, place, code),
               .end = std::min(place + 1, text.size())});
    };
    if (result.IsError() && result.Code() != rapidjson::kParseErrorTermination)
        fail(begin + result.Offset(), result.Code());
    if (result.IsError() || !whole)
        return;
    const std::size_t rest = text.find_first_not_of(" \t\r\n", handler.place());
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
