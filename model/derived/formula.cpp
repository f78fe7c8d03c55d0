// Reads a formula once and evaluates it many times:
// 1. Parts gives each name a variable of muParser and notes which of them the text uses.
// 2. dimension() evaluates with every used name at a number of its own, once as it is and once for
//    each basic unit made smaller; the growth is the power of that unit in the result. A formula
//    that adds unlike things grows by no power and is refused.
// 3. The first listed unit of that dimension names the result, or one is composed of m, kg and s.
// 4. faultOf() says what muParser cannot read, by its code, in sentences that are translated.
// 5. formulasOf() reads the probes of a scene in their order, and offers each formula that it has
//    read to those behind it, so that there are no circles.
#include "derived/formula.h"

#include "base/angle.h"
#include "base/quantity.h"
#include "base/split_mix.h"
#include "scene/expression.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace ripstop {
namespace {

constexpr std::size_t powerOfAngle = 3; // among the powers of a dimension

// Units for results, in the order of preference.
constexpr std::array resultUnits{"m",       "m/s",        "m/s\u00b2", "N",   "J",
                                 "W",       "Pa",         "kg",        "s",   "1/s",
                                 "m\u00b2", "m\u00b3",    "N/m",       "N m", "kg m/s",
                                 "N s",     "kg/m\u00b2", "m\u00b2/s", "1/m", "s/m"};

std::string unitOf(const Dimension& dimension)
{
    for (const char* unit : resultUnits)
        if (const auto measured = measureOfUnit(unit); measured && measured->dimension == dimension)
            return unit;
    std::string text;
    constexpr std::array basic{"m", "kg", "s"};
    for (std::size_t k = 0; k < basic.size(); ++k)
        if (dimension[k] != 0) {
            text.append(text.empty() ? "" : " ").append(basic[k]);
            if (dimension[k] != 1)
                text.append("^").append(std::to_string(dimension[k]));
        }
    return text;
}

constexpr std::string_view nameCharacters =
    "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

using Fault = mu::Parser::exception_type;

bool isFunction(const std::string& token) { return mu::Parser().GetFunDef().contains(token); }

// What muParser does not know reaches to the end of the text where it begins with a sign.
bool isUnknownName(const Fault& error)
{
    const std::string& token = error.GetToken();
    return error.GetCode() == mu::ecUNASSIGNABLE_TOKEN
           && token.find_first_not_of(nameCharacters) == std::string::npos && !isFunction(token);
}

// Counted from 1 and as people count them, while muParser counts bytes from 0.
long characterAt(std::string_view text, const Fault& error)
{
    const auto isFirstByte = [](unsigned char c) { return (c & 0xC0U) != 0x80U; };
    return 1 + std::ranges::count_if(text.substr(0, std::size_t(error.GetPos())), isFirstByte);
}

Message unknown(const Fault& error, long place)
{
    const std::string& token = error.GetToken();
    if (isFunction(token))
        return Message("the function \"%1\" has no brackets behind it: %1(...)", token);
    if (isUnknownName(error))
        return Message("\"%1\" is no other probe; names are written with _ for blanks", token);
    return Message("the sign at character %1 means nothing in a formula", place);
}

Message misplacedComma(long place)
{
    return Message("the comma at character %1 is out of place; decimals have a point", place);
}

// Outside of all brackets, where it would end one formula and begin another; counted from 1.
long commaBetweenFormulas(std::string_view text)
{
    int depth = 0;
    long place = 0;
    for (const unsigned char sign : text) {
        place += (sign & 0xC0U) != 0x80U;
        depth += sign == '(' ? 1 : sign == ')' ? -1 : 0;
        if (sign == ',' && depth == 0)
            break;
    }
    return place;
}

// A function and a text in quotation marks are told without their place, as muParser gives that of
// what follows them.
Message faultOf(const Fault& error, std::string_view text)
{
    const std::string& token = error.GetToken();
    const long place = characterAt(text, error);
    switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
        return unknown(error, place);
    case mu::ecUNEXPECTED_OPERATOR:
        return Message("no number or name stands before \"%1\" at character %2", token, place);
    case mu::ecUNEXPECTED_EOF:
        return Message("it ends where a number or a name has to follow");
    case mu::ecUNEXPECTED_ARG_SEP:
        return misplacedComma(place);
    case mu::ecUNEXPECTED_PARENS:
        if (token == ")")
            return Message("the \")\" at character %1 comes too early or has no \"(\" before it",
                           place);
        [[fallthrough]];
    case mu::ecUNEXPECTED_ARG:
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
        return Message("a sign such as * is missing before \"%1\" at character %2", token, place);
    case mu::ecMISSING_PARENS:
        return Message("a \")\" is missing at its end");
    case mu::ecTOO_MANY_PARAMS:
        return Message("the function \"%1\" has too many values in its brackets", token);
    case mu::ecTOO_FEW_PARAMS:
        return Message("the function \"%1\" has too few values in its brackets", token);
    case mu::ecUNEXPECTED_CONDITIONAL:
    case mu::ecMISSING_ELSE_CLAUSE:
    case mu::ecMISPLACED_COLON:
        return Message("a choice is written condition ? value : other value");
    case mu::ecUNEXPECTED_STR:
    case mu::ecSTRING_EXPECTED:
    case mu::ecVAL_EXPECTED:
    case mu::ecUNTERMINATED_STRING:
    case mu::ecOPRT_TYPE_CONFLICT:
    case mu::ecSTR_RESULT:
        return Message("texts in quotation marks have no place in a formula");
    case mu::ecEXPRESSION_TOO_LONG:
    case mu::ecIDENTIFIER_TOO_LONG:
        return Message("it, or a name in it, is too long");
    default: // faults of programs that use muParser, not of who types
        return Message("it cannot be read");
    }
}

} // namespace

std::string wordFor(std::string_view name)
{
    std::string word(name);
    std::ranges::replace_if(
        word, [](unsigned char c) { return std::isalnum(c) == 0 || c > 127; }, '_');
    if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) != 0)
        word.insert(word.begin(), '_');
    return word;
}

class Formula::Parts
{
public:
    Parts(std::string_view text, std::span<const Name> names)
        : m_values(names.size(), 0.0)
    {
        m_parser.DefineNameChars(nameCharacters.data());
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto unit = measureOfUnit(names[i].unit);
            m_units.push_back(unit.value_or(Measured{1.0, {}, true}));
            m_words.push_back(names[i].name.empty() ? "" : wordFor(names[i].name));
            if (!m_words.back().empty())
                m_parser.DefineVar(m_words.back(), &m_values[i]);
        }
        m_parser.SetExpr(std::string(text));
        const auto& found = m_parser.GetUsedVar();
        for (std::size_t i = 0; i < m_words.size(); ++i)
            if (found.contains(m_words[i]))
                m_used.push_back(i);
    }

    // Evaluates it once, which throws at names that there are not; whether it is a number at all,
    // as far as it hangs on no name: 1 / 0 is none.
    bool isNumber()
    {
        const double number = m_parser.Eval();
        return !m_used.empty() || std::isfinite(number);
    }

    // Of the last time that it was evaluated; commas stand between several.
    int results() const { return m_parser.GetNumResults(); }

    // The dimension of the result; nothing when unlike things are added. A result that depends on
    // an angle by no power, as a sine does, measures no angle. Plain numbers make plain numbers,
    // and so does what has no finite value other than 0 wherever it is tried.
    std::optional<Dimension> dimension()
    {
        if (std::ranges::all_of(m_used, [this](std::size_t i) { return isPlain(m_units[i]); }))
            return Dimension{};
        constexpr std::uint64_t tries =
            200; // roots and logarithms are numbers for some values only
        for (std::uint64_t which = 0; which < tries; ++which)
            if (const std::optional<Growth> growth = grown(which))
                return dimensionOf(*growth);
        return Dimension{};
    }

    double value(std::span<const double> values)
    {
        for (const std::size_t i : m_used)
            m_values[i] = values[i] * m_units[i].value;
        return m_parser.Eval() * m_factor;
    }

    void setUnit(const Dimension& dimension)
    {
        const bool isAngle = dimension == Dimension{0, 0, 0, 1};
        m_unit = isAngle ? "deg" : unitOf({dimension[0], dimension[1], dimension[2], 0});
        m_factor = isAngle ? 1.0 / degrees : 1.0;
    }

    const std::string& unit() const { return m_unit; }
    const std::vector<std::size_t>& used() const { return m_used; }

private:
    static bool isPlain(const Measured& unit) { return unit.dimension == Dimension{}; }

    using Growth = std::array<double, 4>; // of the result with each basic unit

    // How the result grows where each basic unit is made smaller; nothing where it is no number.
    std::optional<Growth> grown(std::uint64_t which)
    {
        const double whole = probed(which, {1.0, 1.0, 1.0, 1.0});
        Growth growth{};
        for (std::size_t k = 0; k < growth.size(); ++k) {
            std::array<double, 4> scale{1.0, 1.0, 1.0, 1.0};
            scale[k] = finer;
            growth[k] = probed(which, scale) / whole;
            if (!std::isfinite(growth[k]) && k != powerOfAngle)
                return std::nullopt;
        }
        return growth;
    }

    static std::optional<Dimension> dimensionOf(const Growth& growth)
    {
        Dimension found{};
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double power = std::log(growth[k]);
            const bool isPower = std::abs(power - std::rint(power)) < 1e-9;
            if (!isPower && k != powerOfAngle)
                return std::nullopt;
            found[k] = isPower ? int(std::lround(power)) : 0;
        }
        return found;
    }

    // Evaluates with another number for each name, so that no difference vanishes.
    double probed(std::uint64_t which, const std::array<double, 4>& scale)
    {
        for (std::size_t n = 0; n < m_used.size(); ++n) {
            const std::size_t i = m_used[n];
            m_values[i] = tried(which, n);
            for (std::size_t k = 0; k < scale.size(); ++k)
                m_values[i] *= std::pow(scale[k], m_units[i].dimension[k]);
        }
        return m_parser.Eval();
    }

    // The value of the n-th name: first about 1, then the other way round, then anywhere from 0.1
    // to 10 and, every other time, below 0.
    static double tried(std::uint64_t which, std::size_t n)
    {
        if (which < 2) {
            const double step = 0.0625 * double(n + 1);
            return 0.5 + (which == 0 ? step : 1.0 / (1.0 + step));
        }
        const std::uint64_t bits = splitMix(which << 16 | n);
        const double size = std::pow(10.0, 2.0 * double(bits >> 11) * 0x1p-53 - 1.0);
        return which % 2 == 1 && (bits & 1) == 1 ? -size : size;
    }

    static constexpr double finer = std::numbers::e; // how much smaller a unit is made

    std::vector<double> m_values; // [names]
    std::vector<Measured> m_units;
    std::vector<std::string> m_words;
    std::vector<std::size_t> m_used;
    std::string m_unit;
    double m_factor = 1.0; // from SI
    mu::Parser m_parser;
};

Formula::Formula(std::unique_ptr<Parts> parts)
    : m_parts(std::move(parts))
{}

Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;
Formula::~Formula() = default;

Result<Formula> Formula::read(std::string_view text, std::span<const Name> names)
{
    if (text.find_first_not_of(' ') == std::string_view::npos)
        return Failure{"it is empty; write one like line_tension / weight"};
    try {
        auto parts = std::make_unique<Parts>(text, names);
        const bool isNumber = parts->isNumber();
        if (parts->results() > 1)
            return Failure{misplacedComma(commaBetweenFormulas(text))};
        if (!isNumber)
            return Failure{"it gives no finite number, as 1/0 does; check what it divides by"};
        const auto dimension = parts->dimension();
        if (!dimension)
            return Failure{"it adds, or takes a function of, things of different units"};
        parts->setUnit(*dimension);
        return Formula(std::move(parts));
    } catch (const Fault& error) {
        return Failure(faultOf(error, text));
    }
}

std::string Formula::unknownName(std::string_view text, std::span<const Name> names)
{
    try {
        (void)Parts(text, names).isNumber();
    } catch (const Fault& error) {
        if (isUnknownName(error))
            return error.GetToken();
    }
    return {};
}

const std::string& Formula::unit() const { return m_parts->unit(); }
const std::vector<std::size_t>& Formula::used() const { return m_parts->used(); }
double Formula::value(std::span<const double> values) { return m_parts->value(values); }

std::vector<ProbeFormula> formulasOf(const Scene& scene)
{
    std::vector<std::pair<Id, const Probe*>> probes;
    std::vector<Formula::Name> names; // nobody can write the empty ones
    for (const Entry& entry : scene.items)
        if (const Probe* probe = std::get_if<Probe>(&entry.item)) {
            const bool isMeasured = probe->quantity != Quantity::Formula;
            probes.emplace_back(entry.id, probe);
            names.push_back({isMeasured ? probe->name : "", std::string(unitOf(probe->quantity))});
        }
    std::vector<ProbeFormula> formulas;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const auto& [id, probe] = probes[i];
        if (probe->quantity != Quantity::Formula)
            continue;
        formulas.push_back({id, Formula::read(probe->formula, names)});
        if (const auto& read = formulas.back().formula)
            names[i] = {probe->name, read->unit()};
    }
    return formulas;
}

} // namespace ripstop
