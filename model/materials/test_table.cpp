// Reading of the table of a test. The first line that is no remark says what separates cells; when
// its cells are no numbers it is the header. Then each row gives two numbers, and every complaint
// names the line as an editor counts them.
#include "materials/material_test.h"
#include "scene/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

struct Line
{
    int number; // from 1
    std::vector<std::string> cells;
};

// Where the two columns are, and SI units in one of theirs.
struct Columns
{
    std::size_t force = 0;
    std::size_t elongation = 1;
    std::size_t count = 2;
    double forceFactor = 1.0;
    double elongationFactor = 1.0; // to TestPoint
};

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r\"");
    if (first == std::string_view::npos)
        return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1));
}

std::optional<double> numberIn(const std::string& cell)
{
    const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
    const char* end = cell.data() + cell.size();
    double value = 0.0;
    const auto [last, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || last != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

bool isDecimalComma(const std::string& cell)
{
    std::string point = cell;
    const auto comma = point.find(',');
    if (comma == std::string::npos)
        return false;
    point[comma] = '.';
    return numberIn(point).has_value();
}

std::vector<std::string> cellsOf(std::string_view line, char separator)
{
    std::vector<std::string> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        cells.push_back(trimmed(line.substr(begin, end - begin)));
        begin = end + 1;
    }
    return cells;
}

std::vector<Line> linesOf(std::string_view text)
{
    std::vector<Line> lines;
    if (text.starts_with("\xef\xbb\xbf")) // as spreadsheets write it
        text.remove_prefix(3);
    char separator = '\0';
    int number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        if (trimmed(line).empty() || line.starts_with('#'))
            continue;
        if (separator == '\0')
            separator = line.find('\t') != std::string_view::npos  ? '\t'
                        : line.find(';') != std::string_view::npos ? ';'
                                                                   : ',';
        lines.push_back({number, cellsOf(line, separator)});
    }
    return lines;
}

// Who writes decimals with a comma parts cells by semicolons or tabs, and writes all decimals so:
// beside a decimal point a comma may part thousands, and nobody knows.
void takeDecimalCommas(std::vector<Line>& lines)
{
    const auto hasAny = [&](auto isOne) {
        return std::ranges::any_of(
            lines, [&](const Line& line) { return std::ranges::any_of(line.cells, isOne); });
    };
    const auto hasPoint = [](const std::string& cell) {
        return numberIn(cell) && cell.find('.') != std::string::npos;
    };
    if (hasAny(hasPoint) || !hasAny(isDecimalComma))
        return;
    for (Line& line : lines)
        for (std::string& cell : line.cells)
            if (isDecimalComma(cell))
                cell[cell.find(',')] = '.';
}

// "Force (N)" is "force" and "N".
std::pair<std::string, std::string> nameAndUnit(std::string cell)
{
    std::string unit;
    const auto open = cell.find_first_of("([");
    if (open != std::string::npos) {
        const auto close = cell.find_first_of(")]", open);
        unit =
            trimmed(cell.substr(open + 1, close == std::string::npos ? close : close - open - 1));
        cell = trimmed(cell.substr(0, open));
    }
    std::ranges::transform(cell, cell.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return {cell, unit};
}

bool isOneOfWords(const std::string& word, std::initializer_list<std::string_view> words)
{
    return std::ranges::any_of(words, [&](std::string_view one) {
        return word == one || word.starts_with(std::string(one) + ' ');
    });
}

bool isForce(const std::string& word)
{
    return isOneOfWords(word, {"force", "load", "pull", "tension", "f"});
}

bool isElongation(const std::string& word)
{
    return isOneOfWords(word, {"elongation", "extension", "stretch", "displacement", "deflection",
                               "strain", "travel", "x"});
}

std::optional<Failure> findColumns(const Line& header, std::string_view name, TestUnits& units,
                                   Columns& columns)
{
    std::optional<std::size_t> force, elongation;
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
        const auto [word, unit] = nameAndUnit(header.cells[i]);
        if (!force && isForce(word)) {
            force = i;
            if (units.force.empty())
                units.force = unit;
        } else if (!elongation && isElongation(word)) {
            elongation = i;
            if (units.elongation.empty())
                units.elongation = unit.empty() && word.starts_with("strain") ? "strain" : unit;
        }
    }
    if (!force || !elongation)
        return Failure("%1, line %2: The header names no column for the %3; write \"force "
                       "(N),elongation (mm)\" for example.",
                       name, header.number, force ? Message("elongation") : Message("force"));
    columns.force = *force;
    columns.elongation = *elongation;
    columns.count = header.cells.size();
    return std::nullopt;
}

// A length is over that of the specimen; a strain of a rod makes no sense.
std::optional<Failure> findUnits(std::string_view name, const TestUnits& units,
                                 const SpecimenSize& size, Columns& columns)
{
    const auto force = units.force.empty() ? std::nullopt : unitFactor(units.force, "N");
    if (!force)
        return Failure("%1: The unit of the force is not told: write \"force (N)\" in the header, "
                       "or give it.",
                       name);
    columns.forceFactor = *force;
    const auto length = units.elongation.empty() ? std::nullopt : unitFactor(units.elongation, "m");
    const auto strain = units.elongation == "strain" || units.elongation == "1" ? std::optional(1.0)
                        : units.elongation.empty()                              ? std::nullopt
                                                   : unitFactor(units.elongation, "");
    if (length && size.specimen == Specimen::Rod)
        columns.elongationFactor = *length;
    else if (length)
        columns.elongationFactor = *length / size.length;
    else if (strain && size.specimen != Specimen::Rod)
        columns.elongationFactor = *strain;
    else if (size.specimen == Specimen::Rod)
        return Failure("%1: The unit of the deflection is not told: write \"deflection (mm)\" in "
                       "the header, or give it.",
                       name);
    else
        return Failure("%1: The unit of the elongation is not told: write \"elongation (mm)\" or "
                       "\"strain (%)\" in the header, or give it.",
                       name);
    return std::nullopt;
}

Result<double> numberAt(const Line& line, std::size_t column, std::string_view name)
{
    const std::string& cell = line.cells[column];
    if (const auto number = numberIn(cell))
        return *number;
    if (isDecimalComma(cell))
        return Failure("%1, line %2: %3 has a decimal comma, and other cells have a decimal point; "
                       "write all decimals alike.",
                       name, line.number, cell);
    return Failure("%1, line %2: \"%3\" is no number.", name, line.number, cell);
}

} // namespace

Result<MaterialTest> readMaterialTest(std::string_view text, std::string_view name,
                                      const SpecimenSize& size, const TestUnits& given)
{
    if (!(size.length > 0.0) || (size.specimen == Specimen::Strip && !(size.width > 0.0)))
        return Failure("The size of the specimen must be told: its length, and of a strip its "
                       "width, above 0.");
    std::vector<Line> lines = linesOf(text);
    if (lines.empty())
        return Failure("%1 has no rows.", name);
    takeDecimalCommas(lines);
    Columns columns;
    TestUnits units = given;
    const bool hasHeader = std::ranges::none_of(lines.front().cells, [](const std::string& cell) {
        return numberIn(cell) || isDecimalComma(cell);
    });
    if (hasHeader) {
        if (const auto failure = findColumns(lines.front(), name, units, columns))
            return *failure;
        lines.erase(lines.begin());
    } else if (units.force.empty() || units.elongation.empty()) {
        return Failure("%1 has no header: begin it with a line like \"force (N),elongation (mm)\", "
                       "or give both units of columns in this order.",
                       name);
    }
    if (const auto failure = findUnits(name, units, size, columns))
        return *failure;
    MaterialTest test;
    std::vector<TestPoint>& points = test.points;
    for (const Line& line : lines) {
        if (line.cells.size() != columns.count)
            return Failure("%1, line %2: It has %3 cells instead of %4; decimals are written with "
                           "a point.",
                           name, line.number, line.cells.size(), columns.count);
        if (line.cells[columns.force].empty() || line.cells[columns.elongation].empty()) {
            test.skipped.push_back(line.number);
            continue;
        }
        const Result<double> force = numberAt(line, columns.force, name);
        if (!force)
            return force.failure();
        const Result<double> elongation = numberAt(line, columns.elongation, name);
        if (!elongation)
            return elongation.failure();
        const TestPoint point{*elongation * columns.elongationFactor, *force * columns.forceFactor};
        if (!points.empty() && point.elongation < points.back().elongation)
            return Failure("%1, line %2: The elongation goes back. A test is one pull, from slack "
                           "until it ends or breaks; leave out the way back.",
                           name, line.number);
        points.push_back(point);
    }
    if (points.size() < 3)
        return Failure("%1 has %2 rows of numbers; a fit needs three or more.", name,
                       points.size());
    return test;
}

std::optional<Message> skippedText(const MaterialTest& test)
{
    if (test.skipped.empty())
        return std::nullopt;
    if (test.skipped.size() == 1)
        return Message("Line %1 has an empty cell and is left out.", test.skipped.front());
    return Message("%1 lines have an empty cell and are left out, the first of them line %2.",
                   test.skipped.size(), test.skipped.front());
}

} // namespace ripstop
