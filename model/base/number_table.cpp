// Lines become cells first, by the separator of the first of them; then decimal commas become
// points, where the whole table has no point.
#include "base/number_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace ripstop {
namespace {

std::optional<double> numberIn(std::string_view cell)
{
    return cellNumber(cell.starts_with('+') ? cell.substr(1) : cell);
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
        cells.emplace_back(cellContent(line.substr(begin, end - begin)));
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
        if (cellContent(line).empty() || line.starts_with('#'))
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

std::string_view cellContent(std::string_view cell)
{
    const auto first = cell.find_first_not_of(" \t\r\"");
    if (first == std::string_view::npos)
        return {};
    return cell.substr(first, cell.find_last_not_of(" \t\r\"") - first + 1);
}

std::optional<double> cellNumber(std::string_view cell)
{
    const std::string_view content = cellContent(cell);
    double value = 0.0;
    const char* const last = content.data() + content.size();
    const auto [end, error] = std::from_chars(content.data(), last, value);
    if (error != std::errc() || end != last || !std::isfinite(value))
        return std::nullopt;
    return value;
}

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
        unit = cellContent(std::string_view(cell).substr(
            open + 1, close == std::string::npos ? close : close - open - 1));
        cell = std::string(cellContent(std::string_view(cell).substr(0, open)));
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
