// Reads clauses from the front of the text: an optional "not", a key, a sign with its spellings,
// and a value that ends at the next "and" between spaces. It keeps the character of each piece, so
// that whoever finds a fault in one can point at it.
#include "select/condition_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace ripstop {
namespace {

struct Sign
{
    std::string_view text;
    Comparison comparison;
};

// Longer signs stand first, so that "<=" is not read as "<".
constexpr std::array signs{Sign{"!=", Comparison::NotEqual},     Sign{"<>", Comparison::NotEqual},
                           Sign{"\u2260", Comparison::NotEqual}, Sign{"<=", Comparison::NotMore},
                           Sign{"\u2264", Comparison::NotMore},  Sign{">=", Comparison::NotLess},
                           Sign{"\u2265", Comparison::NotLess},  Sign{"==", Comparison::Equal},
                           Sign{"=", Comparison::Equal},         Sign{"<", Comparison::Less},
                           Sign{">", Comparison::More}};

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// A text that is read from the front, and where it is.
struct Reader
{
    std::string_view text;
    std::size_t at = 0;

    void skipSpace()
    {
        while (at < text.size() && isSpace(text[at]))
            ++at;
    }
    bool isAtEnd() const { return at >= text.size(); }

    // A word that stands alone.
    bool take(std::string_view word)
    {
        const std::size_t end = at + word.size();
        if (text.substr(at, word.size()) != word || (end < text.size() && !isSpace(text[end])))
            return false;
        at = end;
        return true;
    }
    std::string word()
    {
        const std::size_t from = at;
        while (at < text.size()
               && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_'
                   || text[at] == '.'))
            ++at;
        return std::string(text.substr(from, at - from));
    }
    // As files write it, restLength, or as columns call it: Rest length, words before a sign.
    std::string key()
    {
        const std::string first = word();
        std::string all = first;
        Reader ahead = *this;
        for (ahead.skipSpace(); !ahead.isAtSign(); ahead.skipSpace()) {
            std::string next = ahead.take("and") ? std::string() : ahead.word();
            if (next.empty())
                return first;
            all[0] = char(std::tolower(static_cast<unsigned char>(all[0])));
            next[0] = char(std::toupper(static_cast<unsigned char>(next[0])));
            all += next;
        }
        at = ahead.at;
        return all;
    }
    bool isAtSign() const
    {
        const std::string_view left = text.substr(at);
        return std::ranges::any_of(signs,
                                   [&](const Sign& one) { return left.starts_with(one.text); });
    }
};

// Where the clause ends: at the next "and" between spaces.
std::size_t endOfValue(std::string_view text, std::size_t at)
{
    for (std::size_t i = at; i + 4 <= text.size(); ++i)
        if (isSpace(text[i]) && text.substr(i + 1, 3) == "and"
            && (i + 4 == text.size() || isSpace(text[i + 4])))
            return i;
    return text.size();
}

Result<Clause> readClause(Reader& reader)
{
    Clause clause;
    reader.skipSpace();
    clause.negated = reader.take("not");
    reader.skipSpace();
    clause.keyAt = reader.at;
    clause.key = reader.key();
    if (clause.key.empty())
        return failureAt(reader.at,
                         Message("a property is missing; begin with one, as in mass < 1 g"));
    reader.skipSpace();
    clause.comparisonAt = reader.at;
    const std::string_view left = reader.text.substr(reader.at);
    const auto sign =
        std::ranges::find_if(signs, [&](const Sign& one) { return left.starts_with(one.text); });
    if (sign == signs.end())
        return clause;
    clause.comparison = sign->comparison;
    reader.at += sign->text.size();
    reader.skipSpace();
    clause.valueAt = reader.at;
    const std::size_t end = endOfValue(reader.text, reader.at);
    std::string_view value = reader.text.substr(reader.at, end - reader.at);
    while (!value.empty() && isSpace(value.back()))
        value.remove_suffix(1);
    if (value.empty())
        return failureAt(reader.at, Message("a value is missing after %1", sign->text));
    clause.value = value;
    reader.at = end;
    return clause;
}

} // namespace

Failure failureAt(std::size_t place, const Message& what)
{
    return Failure("At character %1: %2", place + 1, what);
}

Result<std::vector<Clause>> clausesOf(std::string_view text)
{
    Reader reader{text};
    std::vector<Clause> clauses;
    for (;;) {
        auto clause = readClause(reader);
        if (!clause)
            return clause.failure();
        clauses.push_back(std::move(*clause));
        reader.skipSpace();
        if (reader.isAtEnd())
            return clauses;
        if (!reader.take("and"))
            return failureAt(reader.at, Message("expected <, >, =, != or \"and\", not \"%1\"",
                                                text.substr(reader.at)));
    }
}

} // namespace ripstop
