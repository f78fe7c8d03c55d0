// Reads a quantity in these stages:
// 1. The tokenizer takes blanks, numbers, signs and words from the front; signs have several
//    spellings, and a power behind a unit is written out. The first fault ends it.
// 2. ParserText writes the tokens in the language of muParser, with a variable for each number and
//    unit, so that both can be changed between evaluations.
// 3. evaluate() computes the value, and where there is a unit, the dimension: one evaluation for
//    each basic unit made smaller by a factor e, whose logarithm is the power.
// 4. A text that does not fit the wanted dimension is read a second time with each number bound to
//    the unit behind it, because 1/240 s may mean either.
#include "scene/expression.h"

#include <muParser.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

struct Token
{
    enum class Sort { Number, Measure, Function, Sign, Open, Close };
    Sort sort;
    std::size_t at;
    std::string text; // of a sign or a function
    double number = 0.0;
    const Unit* unit = nullptr;
    bool isPower = false; // a number behind ^
};
using enum Token::Sort;

struct Tokens
{
    std::vector<Token> list;
    std::optional<ExpressionFault> fault;
};

struct Spelling
{
    std::string_view typed;
    std::string_view meant;
};

// Signs by all their names, longer ones first where one begins another.
constexpr std::array signs{
    Spelling{"\u2212", "-"}, Spelling{"\u00d7", "*"},      Spelling{"\u00b7", "*"},
    Spelling{"\u22c5", "*"}, Spelling{"\u00f7", "/"},      Spelling{"**", "^"},
    Spelling{"+", "+"},      Spelling{"-", "-"},           Spelling{"*", "*"},
    Spelling{"/", "/"},      Spelling{"^", "^"},           Spelling{"(", "("},
    Spelling{")", ")"},      Spelling{"\u00b2", "\u00b2"}, Spelling{"\u00b3", "\u00b3"}};
constexpr std::array<std::string_view, 5> blanks{" ", "\t", "\u00a0", "\u202f", "\u2009"};
constexpr std::array<std::string_view, 2> functions{"sqrt", "abs"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Tokenizer
{
public:
    explicit Tokenizer(std::string_view text)
        : m_text(text)
    {}

    Tokens run()
    {
        while (m_at < m_text.size() && !m_tokens.fault)
            if (!takeBlank() && !takeNumber() && !takeSign() && !takeWord())
                fail(ExpressionFault::Sort::NotANumber, {});
        return std::move(m_tokens);
    }

private:
    std::string_view left() const { return m_text.substr(m_at); }

    void fail(ExpressionFault::Sort sort, std::string_view word)
    {
        m_tokens.fault = ExpressionFault{sort, m_at, std::string(word)};
    }

    void add(Token::Sort sort, std::string_view text, double number = 0.0)
    {
        const bool isPower =
            sort == Number && !m_tokens.list.empty() && m_tokens.list.back().text == "^";
        m_tokens.list.push_back({sort, m_at, std::string(text), number, nullptr, isPower});
    }

    bool takeBlank()
    {
        for (const std::string_view blank : blanks)
            if (left().starts_with(blank)) {
                m_at += blank.size();
                return true;
            }
        return false;
    }

    std::size_t digitsFrom(std::size_t at) const
    {
        while (at < m_text.size() && isDigit(m_text[at]))
            ++at;
        return at;
    }

    // Takes a number. Decimals may have a comma, and an e that no digits follow begins a word.
    bool takeNumber()
    {
        std::size_t end = digitsFrom(m_at);
        const bool hasWhole = end > m_at;
        if (end < m_text.size() && (m_text[end] == '.' || m_text[end] == ',')) {
            const std::size_t decimals = digitsFrom(end + 1);
            if (decimals > end + 1 || (hasWhole && m_text[end] == '.'))
                end = decimals;
        }
        if (end == m_at)
            return false;
        if (end < m_text.size() && (m_text[end] == 'e' || m_text[end] == 'E')) {
            std::size_t exponent = end + 1;
            if (exponent < m_text.size() && (m_text[exponent] == '-' || m_text[exponent] == '+'))
                ++exponent;
            if (const std::size_t stop = digitsFrom(exponent); stop > exponent)
                end = stop;
        }
        std::string digits(m_text.substr(m_at, end - m_at));
        std::ranges::replace(digits, ',', '.');
        double number = 0.0;
        const auto [stop, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error != std::errc() || stop != digits.data() + digits.size())
            fail(ExpressionFault::Sort::NotANumber, {}); // beyond what a double holds
        add(Number, {}, number);
        m_at = end;
        return true;
    }

    bool takeSign()
    {
        for (const Spelling& sign : signs) {
            if (!left().starts_with(sign.typed))
                continue;
            if (sign.meant == "(" || sign.meant == ")") {
                add(sign.meant == "(" ? Open : Close, sign.meant);
            } else if (sign.meant == "\u00b2" || sign.meant == "\u00b3") {
                add(Sign, "^");
                add(Number, {}, sign.meant == "\u00b2" ? 2.0 : 3.0);
            } else {
                add(Sign, sign.meant);
            }
            m_at += sign.typed.size();
            return true;
        }
        return false;
    }

    // Takes a unit, a function or pi. A digit right behind a unit is its power.
    bool takeWord()
    {
        std::size_t end = m_at;
        while (end < m_text.size() && isLetter(m_text[end]))
            ++end;
        std::string word(m_text.substr(m_at, end - m_at));
        if (left().starts_with("\u00b5") || left().starts_with("\u03bc")) { // micro
            end = m_at + 2;
            while (end < m_text.size() && isLetter(m_text[end]))
                ++end;
            word = std::string(1, 'u').append(m_text.substr(m_at + 2, end - m_at - 2));
        }
        for (const std::string_view mark : {"%", "\u2030", "\u00b0"})
            if (left().starts_with(mark)) {
                word = mark;
                end = m_at + mark.size();
            }
        if (word.empty())
            return false;
        if (word == "pi") {
            add(Number, {}, std::numbers::pi);
        } else if (std::ranges::find(functions, word) != functions.end()) {
            add(Function, word);
        } else if (const Unit* unit = findUnit(word)) {
            add(Measure, word);
            m_tokens.list.back().unit = unit;
            m_at = end;
            if (const std::size_t power = digitsFrom(end); power == end + 1) {
                add(Sign, "^");
                add(Number, {}, double(m_text[end] - '0'));
                end = power;
            }
        } else {
            fail(ExpressionFault::Sort::UnknownUnit, word);
        }
        m_at = end;
        return true;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    Tokens m_tokens;
};

// Whether the unit of a number goes into a division together with it: 1 m / 2 s.
enum class Binding { Loose, Tight };

// The tokens in the language of muParser, with products written out and a variable for each number
// and unit.
class ParserText
{
public:
    ParserText(const std::vector<Token>& tokens, Binding binding)
        : m_tokens(tokens)
        , m_values(tokens.size())
    {
        m_parser.ClearConst();
        m_parser.ClearFun();
        m_parser.DefineFun("sqrt", static_cast<double (*)(double)>(std::sqrt));
        m_parser.DefineFun("abs", static_cast<double (*)(double)>(std::abs));
        bool isOpen = false; // a bracket around a number and its units
        std::string text;
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            const Token& token = tokens[i];
            const bool isPowerNext = token.text == "^" || token.isPower;
            if (isOpen && token.sort != Measure && !isPowerNext) {
                text += ')';
                isOpen = false;
            }
            if (i > 0 && isProduct(tokens[i - 1], token, i))
                text += '*';
            if (binding == Binding::Tight && token.sort == Number && !token.isPower
                && i + 1 < tokens.size() && tokens[i + 1].sort == Measure) {
                text += '(';
                isOpen = true;
            }
            text += nameOf(i);
        }
        m_parser.SetExpr(isOpen ? text + ')' : text);
    }

    // Evaluates with basic units that are smaller by these factors. `isProbe` puts other numbers in
    // place of the typed ones, so that zeros and differences do not hide a dimension.
    double value(const std::array<double, 4>& scale, bool isProbe)
    {
        double shift = 1.0;
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            const Token& token = m_tokens[i];
            if (token.sort == Measure) {
                m_values[i] = token.unit->factor;
                for (std::size_t k = 0; k < scale.size(); ++k)
                    m_values[i] *= std::pow(scale[k], token.unit->dimension[k]);
            } else if (token.sort == Number) {
                m_values[i] = token.number;
                if (isProbe && !token.isPower)
                    m_values[i] = (token.number == 0.0 ? 1.0 : token.number) * (shift += 0.0625);
            }
        }
        return m_parser.Eval();
    }

private:
    static bool isEnd(const Token& token)
    {
        return token.sort == Number || token.sort == Measure || token.sort == Close;
    }

    // Whether a product sign is missing before the token, as in "5 kg", "2 (3 m)" or "5 1/s".
    bool isProduct(const Token& before, const Token& token, std::size_t i) const
    {
        if (!isEnd(before) || token.isPower)
            return false;
        const bool isOneOver = token.sort == Number && token.number == 1.0
                               && i + 2 < m_tokens.size() && m_tokens[i + 1].text == "/"
                               && m_tokens[i + 2].sort == Measure;
        return token.sort == Measure || token.sort == Open || token.sort == Function || isOneOver;
    }

    std::string nameOf(std::size_t i)
    {
        const Token& token = m_tokens[i];
        if (token.sort != Number && token.sort != Measure)
            return token.text;
        const std::string name = std::string(1, 'v').append(std::to_string(i));
        m_parser.DefineVar(name, &m_values[i]);
        return name;
    }

    const std::vector<Token>& m_tokens;
    std::vector<double> m_values;
    mu::Parser m_parser;
};

// The dimension of the value; nothing when unlike things are added.
std::optional<Dimension> dimensionOf(ParserText& formula)
{
    constexpr double finer = std::numbers::e; // no power of it is a number that people type
    const double whole = formula.value({1.0, 1.0, 1.0, 1.0}, true);
    Dimension dimension{};
    for (std::size_t k = 0; k < dimension.size(); ++k) {
        std::array<double, 4> scale{1.0, 1.0, 1.0, 1.0};
        scale[k] = finer;
        const double power = std::log(formula.value(scale, true) / whole);
        if (!(std::abs(power - std::rint(power)) < 1e-9))
            return std::nullopt;
        dimension[k] = int(std::lround(power));
    }
    return dimension;
}

Expression evaluateBound(const Tokens& tokens, Binding binding)
{
    try {
        ParserText formula(tokens.list, binding);
        const double value = formula.value({1.0, 1.0, 1.0, 1.0}, false);
        const auto firstUnit = std::ranges::find(tokens.list, Measure, &Token::sort);
        const bool hasUnit = firstUnit != tokens.list.end();
        if (!hasUnit)
            return {Measured{value, {}, false}, {}};
        if (const auto dimension = dimensionOf(formula))
            return {Measured{value, *dimension, true}, {}};
        return {std::nullopt, {ExpressionFault::Sort::UnlikeSum, firstUnit->at, {}}};
    } catch (const mu::Parser::exception_type&) {
        return {std::nullopt, {ExpressionFault::Sort::NotANumber, 0, {}}};
    }
}

} // namespace

Expression evaluate(std::string_view text, const Dimension& wanted)
{
    const Tokens tokens = Tokenizer(text).run();
    if (tokens.fault)
        return {std::nullopt, *tokens.fault};
    if (tokens.list.size() == 1 && tokens.list[0].sort == Number)
        return {Measured{tokens.list[0].number, {}, false}, {}};
    const Expression loose = evaluateBound(tokens, Binding::Loose);
    const auto fits = [&](const Expression& read) {
        return read.quantity && (!read.quantity->hasUnit || read.quantity->dimension == wanted);
    };
    if (fits(loose))
        return loose;
    const Expression tight = evaluateBound(tokens, Binding::Tight);
    return fits(tight) || !loose.quantity ? tight : loose;
}

std::optional<Measured> measureOfUnit(std::string_view unit)
{
    if (unit.empty())
        return Measured{1.0, {}, true};
    return evaluate(std::string("1 ").append(unit), {}).quantity;
}

} // namespace ripstop
