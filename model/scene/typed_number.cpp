// Reads what a person types for a number:
// 1. A sign at the front says whether the text is a factor (* or /), a term (+, +=, -=) or the
//    value itself; a minus alone belongs to the number, and a signed number that ends with % is a
//    factor.
// 2. plain() reads what is left as an expression (expression.h) and converts it to the wanted
//    unit. A complaint names units that would fit and the character that it is about.
// 3. changed() applies the result to a value of any numeric type.
#include "scene/typed_number.h"

#include "scene/expression.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

// A text that is read from both ends, and where what is left of it begins.
struct Rest
{
    std::string_view text;
    std::size_t at = 0;

    void trim()
    {
        const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
        while (!text.empty() && isBlank(text.front()))
            drop(1);
        while (!text.empty() && isBlank(text.back()))
            text.remove_suffix(1);
    }
    void drop(std::size_t count)
    {
        text.remove_prefix(count);
        at += count;
    }
    bool take(std::string_view mark)
    {
        if (!text.starts_with(mark))
            return false;
        drop(mark.size());
        trim();
        return true;
    }
};

constexpr std::string_view minus = "\u2212"; // the typographic one

// Up to five units that fit, as "kg, g or t": a few are enough to see what is meant.
Message offered(std::string_view wanted)
{
    const std::vector<std::string> units = unitsLike(wanted);
    const std::size_t most = std::min<std::size_t>(units.size(), 5);
    std::string list;
    for (std::size_t i = 0; i + 1 < most; ++i)
        list += (i == 0 ? "" : ", ") + units[i];
    if (most < 2)
        return Message::verbatim(most == 1 ? units[0] : std::string());
    return Message("%1 or %2", list, units[most - 1]);
}

Message complaintAbout(const ExpressionFault& fault, std::string_view wanted)
{
    const Message units = offered(wanted);
    switch (fault.sort) {
    case ExpressionFault::Sort::UnknownUnit:
        return units.empty() ? Message("must be a number without a unit")
                             : Message("must be a number in %1", units);
    case ExpressionFault::Sort::UnlikeSum:
        return units.empty()
                   ? Message("must be a sum of numbers in one kind of unit")
                   : Message("must be a sum of numbers in one kind of unit, such as %1", units);
    case ExpressionFault::Sort::WrongUnit:
        return wanted.empty() ? Message("must be a number without a unit")
                              : Message("must be in %1", units);
    case ExpressionFault::Sort::NotANumber:
        break;
    }
    return Message("must be a number");
}

Typed refusedFor(ExpressionFault fault, const Rest& rest, std::string_view wanted)
{
    const bool isUnit = fault.sort == ExpressionFault::Sort::UnknownUnit
                        || fault.sort == ExpressionFault::Sort::WrongUnit;
    return {std::nullopt, complaintAbout(fault, wanted), rest.at + fault.at,
            isUnit ? fault.word : std::string()};
}

// Where the unit of a text begins: at the first letter or sign that numbers have not.
std::size_t unitAt(std::string_view text)
{
    return std::min(text.find_first_not_of("0123456789.,+-*/^() \te"), text.size());
}

// Rounds to 15 digits, so that 7 cm is 0.07 m and not its neighbour by a binary product.
double clean(double value)
{
    char text[32];
    const auto [end, error] =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 15);
    if (std::isfinite(value) && error == std::errc())
        std::from_chars(text, end, value);
    return value;
}

// A number and nothing else, which studies read by the hundred thousand.
std::optional<double> bareNumber(std::string_view text)
{
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

// Where "7,000" begins, a number that may be one of thousands, as 0,125 and 1234,567 cannot be.
std::optional<std::size_t> thousandsAt(std::string_view text)
{
    constexpr std::string_view digits = "0123456789";
    const auto isOf = [&](std::size_t at, std::string_view some) {
        return at < text.size() && some.find(text[at]) != std::string_view::npos;
    };
    for (std::size_t comma = text.find(','); comma != std::string_view::npos;
         comma = text.find(',', comma + 1)) {
        std::size_t begin = comma, end = comma + 1;
        while (begin > 0 && isOf(begin - 1, digits))
            --begin;
        while (isOf(end, digits))
            ++end;
        const bool isWhole = (begin == 0 || !isOf(begin - 1, ".,")) && !isOf(end, ".,");
        const std::size_t before = comma - begin;
        if (isWhole && before >= 1 && before <= 3 && text[begin] != '0' && end == comma + 4)
            return begin;
    }
    return std::nullopt;
}

// Reads the whole text as a value in the wanted unit.
Typed plain(const Rest& rest, std::string_view wanted)
{
    if (const auto number = bareNumber(rest.text))
        return {TypedNumber{TypedNumber::Sort::Absolute, *number}, {}, 0, {}};
    const std::optional<Measured> unit = measureOfUnit(wanted);
    Expression read = evaluate(rest.text, unit ? unit->dimension : Dimension{});
    if (!read.quantity)
        return refusedFor(std::move(read.fault), rest, wanted);
    const Measured& quantity = *read.quantity;
    if (!quantity.hasUnit)
        return {TypedNumber{TypedNumber::Sort::Absolute, quantity.value}, {}, 0, {}};
    if (unit && quantity.dimension == unit->dimension)
        return {TypedNumber{TypedNumber::Sort::Absolute, clean(quantity.value / unit->value)},
                {},
                0,
                {}};
    const std::size_t at = unitAt(rest.text);
    return refusedFor({ExpressionFault::Sort::WrongUnit, at, std::string(rest.text.substr(at))},
                      rest, wanted);
}

} // namespace

double TypedNumber::appliedTo(double before) const
{
    if (sort == Sort::Absolute)
        return number;
    return sort == Sort::Times ? before * number : before + number;
}

Typed typedNumber(std::string_view text, std::string_view wanted)
{
    using enum TypedNumber::Sort;
    Rest rest{text};
    rest.trim();
    const auto as = [](Typed typed, TypedNumber::Sort sort, auto change) {
        if (typed.number)
            typed.number = TypedNumber{sort, change(typed.number->number)};
        return typed;
    };

    if (rest.take("*") || rest.take("\u00d7"))
        return as(plain(rest, {}), Times, [](double factor) { return factor; });
    if (rest.take("/"))
        return as(plain(rest, {}), Times, [](double divisor) { return 1.0 / divisor; });

    const bool plusEquals = rest.take("+=");
    const bool minusEquals = !plusEquals && (rest.take("-=") || rest.take("\u2212="));
    const Rest whole = rest;
    const bool plus = plusEquals || (!minusEquals && rest.take("+"));
    const bool isNegative = !plus && !minusEquals && (rest.take("-") || rest.take(minus));
    const double sign = minusEquals || isNegative ? -1.0 : 1.0;
    if ((plus || minusEquals || isNegative) && rest.text.ends_with('%')) {
        Rest share = rest; // "+5 %" is a change, whatever is wanted
        share.text.remove_suffix(1);
        if (const Typed percent = plain(share, {}); percent.number)
            return as(percent, Times, [=](double size) { return 1.0 + sign * size / 100.0; });
    }
    if (plus || minusEquals)
        return as(plain(rest, wanted), Plus, [=](double term) { return sign * term; });
    return plain(whole, wanted);
}

Value changed(const Value& before, const TypedNumber& typed, int axis)
{
    if (const double* real = std::get_if<double>(&before))
        return typed.appliedTo(*real);
    if (const int* whole = std::get_if<int>(&before)) {
        const double result = typed.appliedTo(*whole);
        const bool fits = std::abs(result) < 2e9;
        // A number that is not whole stays a double, which refusal() then refuses by its type.
        const bool isWhole =
            typed.sort != TypedNumber::Sort::Absolute || result == std::rint(result);
        return fits && isWhole ? Value(int(std::lround(result))) : Value(result);
    }
    if (const Vec3* vector = std::get_if<Vec3>(&before)) {
        Vec3 result = *vector;
        result[axis] = typed.appliedTo(result[axis]);
        return result;
    }
    // The value is absent: only a value of its own can take its place.
    return typed.sort == TypedNumber::Sort::Absolute ? Value(typed.number) : before;
}

Typed typedValue(std::string_view text, std::string_view wanted, ThreeDigits behindComma)
{
    const auto thousands =
        behindComma == ThreeDigits::AreRefused ? thousandsAt(text) : std::nullopt;
    if (thousands) {
        const std::size_t comma = text.find(',', *thousands);
        const std::string whole(text.substr(*thousands, comma - *thousands));
        const std::string behind(text.substr(comma + 1, 3));
        return {std::nullopt,
                Message("must be written with %1 or %2, as the comma may mean either",
                        whole + behind, whole + '.' + behind),
                *thousands,
                {}};
    }
    Rest rest{text};
    rest.trim();
    if (!rest.text.starts_with("+="))
        (void)rest.take("+");
    return plain(rest, wanted);
}

} // namespace ripstop
