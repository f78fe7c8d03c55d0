// Lines become cells first, by the separator of the first of them; then decimal commas become
// points, where the whole table has no point.
#include "base/number_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

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

std::vector<TableLine> rawLines(std::string_view text)
{
    std::vector<TableLine> lines;
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
void takeDecimalCommas(std::vector<TableLine>& lines)
{
    const auto hasAny = [&](auto isOne) {
        return std::ranges::any_of(
            lines, [&](const TableLine& line) { return std::ranges::any_of(line.cells, isOne); });
    };
    const auto hasPoint = [](const std::string& cell) {
        return numberIn(cell) && cell.find('.') != std::string::npos;
    };
    if (hasAny(hasPoint) || !hasAny(isDecimalComma))
        return;
    for (TableLine& line : lines)
        for (std::string& cell : line.cells)
            if (isDecimalComma(cell))
                cell[cell.find(',')] = '.';
}

} // namespace

std::vector<TableLine> tableLines(std::string_view text)
{
    std::vector<TableLine> lines = rawLines(text);
    takeDecimalCommas(lines);
    return lines;
}

bool isHeader(const TableLine& line)
{
    return std::ranges::none_of(
        line.cells, [](const std::string& cell) { return numberIn(cell) || isDecimalComma(cell); });
}

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

Result<double> numberAt(const TableLine& line, std::size_t column, std::string_view name)
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

} // namespace ripstop
