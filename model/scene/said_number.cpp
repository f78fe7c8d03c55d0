// A number is said in a unit of the table below: that of the first word of its own with a prefix,
// as far as units.h can read it back.
#include "scene/said_number.h"

#include "scene/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace ripstop {
namespace {

constexpr double nothing = 1e-9;          // in SI: what is less is an error of rounding
constexpr double nothingInMetres = 1e-8;  // of places that many pulls have come to rest at
constexpr double nothingInPercent = 1e-4; // a strain of 1e-6, which nobody measures on fabric

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

// In the unit that has this word for its first one; nothing where it cannot be typed.
std::optional<NumberInUnit> saidIn(std::string_view first, double value, std::string_view unit)
{
    if (first.empty())
        return std::nullopt;
    const std::string whole = std::string(first) + std::string(unit.substr(lengthOfFirst(unit)));
    const std::optional<double> factor = unitFactor(whole, unit);
    return factor ? std::optional(NumberInUnit{value / *factor, whole}) : std::nullopt;
}

} // namespace

NumberInUnit inReadableUnit(double value, std::string_view unit)
{
    const Prefixes* row = prefixesOf(unit);
    return inReadableUnit(value, unit, row ? row->least : 0.0, mostPlain);
}

NumberInUnit inReadableUnit(double value, std::string_view unit, double least, double most)
{
    NumberInUnit best{value, std::string(unit)};
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

ReadableUnit readableUnit(double largest, std::string_view unit)
{
    if (!std::isfinite(largest) || isNothing(largest, unit))
        return {1.0, std::string(unit)};
    NumberInUnit said = inReadableUnit(largest, unit);
    const double factor = unitFactor(said.unit, unit).value_or(1.0);
    return {factor, std::move(said.unit)};
}

std::string plainNumber(double number, int digits)
{
    if (number == 0.0 || !std::isfinite(number))
        return number == 0.0 ? "0" : "\u2013";
    std::array<char, 40> text;
    if (std::abs(number) >= mostDigits) {
        char* end = std::to_chars(text.data(), text.data() + text.size(), number,
                                  std::chars_format::general, digits)
                        .ptr;
        return {text.data(), end};
    }
    const int before = int(std::floor(std::log10(std::abs(number)) + 1e-12));
    const int decimals = std::clamp(digits - 1 - before, 0, 20);
    char* end = std::to_chars(text.data(), text.data() + text.size(), number,
                              std::chars_format::fixed, decimals)
                    .ptr;
    if (decimals > 0) {
        while (end[-1] == '0')
            --end;
        if (end[-1] == '.')
            --end;
    }
    const std::string said(text.data(), end);
    return said == "-0" ? "0" : said;
}

bool isNothing(double value, std::string_view unit)
{
    return std::abs(value) < (unit == "%"   ? nothingInPercent
                              : unit == "m" ? nothingInMetres
                                            : nothing);
}

Message saidNumber(double value, std::string_view unit, int digits)
{
    if (!std::isfinite(value))
        return Message::verbatim("\u2013");
    NumberInUnit said{0.0, std::string(unit)};
    if (!isNothing(value, unit))
        said = inReadableUnit(value, unit);
    Message number = Message::number(plainNumber(said.number, digits));
    return said.unit.empty() ? number : Message("%1 %2", std::move(number), std::move(said.unit));
}

} // namespace ripstop
