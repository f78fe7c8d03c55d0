// plain() writes a number without an exponent. prefixed() finds the units that a value may be said
// in: those of the first word of its unit with a prefix, as far as units.h can read them back. A
// scale takes that of its largest value.
#include "document/spoken.h"

#include "document/words.h"
#include "scene/units.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace ripstop {
namespace {

constexpr double nothing = 1e-9; // in SI: what is less is an error of rounding
constexpr int fieldDigits = 6;   // as compactNumber() has
constexpr double leastInField = 1e-3;
constexpr double mostInField = 1e6;

// Of the unit alone, as far as the first sign that joins it with others.
struct Prefixes
{
    std::string_view unit;
    std::array<std::string_view, 2> smaller; // the larger one first
    std::array<std::string_view, 2> larger;
    double least; // what is below is said in a smaller one
};

// clang-format off
constexpr std::array table{
    Prefixes{"m",       {"mm", "\u00b5m"},      {"km", ""},     0.01},
    Prefixes{"m\u00b2", {"cm\u00b2", "mm\u00b2"}, {"", ""},     0.01},
    Prefixes{"kg",      {"g", "mg"},            {"", ""},       1.0},
    Prefixes{"s",       {"ms", "\u00b5s"},      {"", ""},       0.01},
    Prefixes{"N",       {"mN", ""},             {"kN", "MN"},   0.01},
    Prefixes{"Pa",      {"", ""},               {"kPa", "MPa"}, 0.0},
    Prefixes{"J",       {"mJ", "\u00b5J"},      {"kJ", ""},     0.01},
};
// clang-format on

constexpr double mostPlain = 1e4; // from here on a larger unit is said
constexpr double mostWithPrefix = 1e3;
constexpr double leastSaid = 0.1; // of a smaller unit, before a still smaller one

std::size_t lengthOfFirst(std::string_view unit)
{
    return std::min(unit.find_first_of(" /"), unit.size());
}

const Prefixes* prefixesOf(std::string_view unit)
{
    const std::string_view first = unit.substr(0, lengthOfFirst(unit));
    for (const Prefixes& row : table)
        if (row.unit == first)
            return &row;
    return nullptr;
}

struct Said
{
    double number;
    std::string unit;
};

// In the unit that has this word for its first one; nothing where it cannot be typed.
std::optional<Said> saidIn(std::string_view first, double value, std::string_view unit)
{
    if (first.empty())
        return std::nullopt;
    const std::string whole = std::string(first) + std::string(unit.substr(lengthOfFirst(unit)));
    const std::optional<double> factor = unitFactor(whole, unit);
    return factor ? std::optional(Said{value / *factor, whole}) : std::nullopt;
}

Said prefixed(double value, std::string_view unit, double least, double most)
{
    Said best{value, std::string(unit)};
    const Prefixes* row = prefixesOf(unit);
    if (!row)
        return best;
    if (std::abs(value) < least) {
        for (const std::string_view first : row->smaller)
            if (best.unit == unit || std::abs(best.number) < leastSaid)
                if (const auto said = saidIn(first, value, unit))
                    best = *said;
    } else {
        for (const std::string_view first : row->larger)
            if (std::abs(best.number) >= (best.unit == unit ? most : mostWithPrefix))
                if (const auto said = saidIn(first, value, unit))
                    best = *said;
    }
    return best;
}

QString plain(double number, int digits)
{
    if (number == 0.0)
        return QStringLiteral("0");
    const int before = int(std::floor(std::log10(std::abs(number)) + 1e-12));
    const int decimals = std::clamp(digits - 1 - before, 0, 20);
    QString text = QString::number(number, 'f', decimals);
    if (decimals > 0) {
        while (text.endsWith(QChar('0')))
            text.chop(1);
        if (text.endsWith(QChar('.')))
            text.chop(1);
    }
    if (text == QLatin1String("-0"))
        text = QStringLiteral("0");
    return text.replace(QChar('.'), QLocale().decimalPoint());
}

bool isNothing(double value, std::string_view unit)
{
    return std::abs(value) < (unit == "%" ? 100.0 * nothing : nothing);
}

} // namespace

QString Spoken::text() const { return unit.isEmpty() ? number : number + QChar(0x00a0) + unit; }

Spoken spoken(double value, std::string_view unit, int digits)
{
    if (isNothing(value, unit))
        return {QStringLiteral("0"), text(unit)};
    const Prefixes* row = prefixesOf(unit);
    const Said said = prefixed(value, unit, row ? row->least : 0.0, mostPlain);
    return {plain(said.number, digits), text(said.unit)};
}

QString spokenText(double value, std::string_view unit, int digits)
{
    return std::isfinite(value) ? spoken(value, unit, digits).text() : QString(QChar(0x2013));
}

bool isSaidInPercent(Quantity quantity)
{
    return quantity == Quantity::Strain || quantity == Quantity::MaxStrain
           || quantity == Quantity::MeanStrain || quantity == Quantity::HighStrain
           || quantity == Quantity::WrinkledShare;
}

QString readingText(bool isShare, double value, std::string_view unit, int digits)
{
    return isShare ? spokenText(100.0 * value, "%", digits) : spokenText(value, unit, digits);
}

QString readingText(Quantity quantity, double value, std::string_view unit, int digits)
{
    return readingText(isSaidInPercent(quantity), value, unit, digits);
}

QString spokenNumber(double value, int digits)
{
    return std::isfinite(value) ? plain(value, digits) : QString(QChar(0x2013));
}

double heldValue(double value) { return std::abs(value) < nothing ? 0.0 : value; }

double roundStep(double least)
{
    if (!(least > 0.0) || !std::isfinite(least))
        return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(least) + 1e-9));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least * (1.0 - 1e-9))
            return step * power;
    return 10.0 * power;
}

SpokenScale spokenScale(double largest, std::string_view unit, bool isShare)
{
    if (isShare)
        return {0.01, QStringLiteral("%")};
    const Prefixes* row = prefixesOf(unit);
    if (!row || heldValue(largest) == 0.0)
        return {1.0, text(unit)};
    const Said said = prefixed(largest, unit, row->least, mostPlain);
    return {unitFactor(said.unit, unit).value_or(1.0), text(said.unit)};
}

QString SpokenScale::number(double value, int digits) const
{
    return spokenNumber(heldValue(value) / factor, digits);
}

QString SpokenScale::atStep(double value, double step) const
{
    const double said = value / factor;
    const double apart = step / factor;
    if (!(apart > 0.0) || std::abs(said) < 1e-6 * apart)
        return QStringLiteral("0");
    const int decimals = std::clamp(int(std::ceil(-std::log10(apart) - 1e-9)), 0, 20);
    return QString::number(said, 'f', decimals).replace(QChar('.'), QLocale().decimalPoint());
}

Spoken spokenInField(double value, std::string_view unit)
{
    const double size = std::abs(value);
    if (size == 0.0 || (size >= leastInField && size < mostInField) || !std::isfinite(value))
        return {compactNumber(value), text(unit)};
    const Said said = prefixed(value, unit, leastInField, mostInField);
    const QString number = plain(said.number, fieldDigits);
    return said.unit == unit ? Spoken{number, text(unit)}
                             : Spoken{number + QChar(' ') + text(said.unit), QString()};
}

} // namespace ripstop
