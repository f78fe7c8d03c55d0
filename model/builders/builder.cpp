// The table of builders and what is the same for all of them:
// 1. The refusals: a parameter that does not exist, one out of range, and a cell of a table out of
//    range, each by name and with the nearest name or the interval.
// 2. The table itself, by family.
// 3. build() fills in defaults, checks what is given, and calls the row, which may rely on every
//    number.
// 4. Tables of numbers: as cells among the parameters, and from the text of a spreadsheet.
#include "builders/builder.h"

#include "builders/designs.h"
#include "scene/property.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

const Parameter* findParameter(const Builder& builder, std::string_view key)
{
    for (const Parameter& parameter : builder.parameters)
        if (parameter.key == key)
            return &parameter;
    return nullptr;
}

Failure unknown(const Builder& builder, const std::string& key)
{
    std::vector<std::string_view> keys;
    for (const Parameter& parameter : builder.parameters)
        keys.push_back(parameter.key);
    const std::string_view near = nearest(key, keys);
    if (!near.empty())
        return Failure("The builder %1 has no parameter \"%2\"; did you mean \"%3\"?", builder.name,
                       key, near);
    std::string list;
    for (const std::string_view one : keys)
        list += (list.empty() ? "" : ", ") + std::string(one);
    return Failure("The builder %1 has no parameter \"%2\"; it has %3.", builder.name, key, list);
}

Message inShort(double value) { return Message::number("%g", value); }

Message withUnit(const Message& number, std::string_view unit)
{
    return unit.empty() ? number : Message("%1 %2", number, unit);
}

std::optional<Failure> refused(const Parameter& parameter, double value)
{
    const bool inRange = value >= parameter.low && value <= parameter.high; // false for NaN
    if (inRange && (!parameter.whole || value == std::floor(value)))
        return std::nullopt;
    const Message low = inShort(parameter.low), high = inShort(parameter.high);
    if (parameter.whole)
        return Failure("%1 must be a whole number from %2 to %3, and is %4.", parameter.key, low,
                       withUnit(high, parameter.unit), inShort(value));
    return Failure("%1 must be a number from %2 to %3, and is %4.", parameter.key, low,
                   withUnit(high, parameter.unit), inShort(value));
}

std::string cellKey(const TableParameter& table, std::size_t row, std::size_t column)
{
    return std::string(table.key) + "." + std::to_string(row + 1) + "."
           + std::to_string(column + 1);
}

bool isCell(const Builder& builder, std::string_view key)
{
    return builder.table && key.starts_with(std::string(builder.table->key) + ".");
}

std::optional<Failure> refused(const TableParameter& parameter, const NumberRows& table)
{
    for (std::size_t row = 0; row < table.size(); ++row) {
        const std::size_t count = std::min(table[row].size(), table[0].size());
        if (table[row].size() != table[0].size())
            return Failure("%1, row %2, column %3: each row needs as many numbers as the first, "
                           "%4, and this one has %5.",
                           parameter.key, row + 1, count + 1, table[0].size(), table[row].size());
        for (std::size_t column = 0; column < count; ++column) {
            const double value = table[row][column];
            if (value >= parameter.low && value <= parameter.high)
                continue; // false for NaN
            return Failure("%1, row %2, column %3: must be from %4 to %5 %6, and is %7.",
                           parameter.key, row + 1, column + 1, inShort(parameter.low),
                           inShort(parameter.high), parameter.unit, inShort(value));
        }
    }
    return std::nullopt;
}

// Between tabs a cell may be written with a comma and be empty; else commas and blanks part cells.
std::vector<std::string> cellsOf(std::string_view row)
{
    const bool tabs = row.find('\t') != std::string_view::npos;
    std::vector<std::string> cells(1);
    for (const char letter : row) {
        if (letter == '\t' || (!tabs && letter == ','))
            cells.emplace_back();
        else if (letter == ' ' && !tabs && !cells.back().empty())
            cells.emplace_back();
        else if (letter != ' ' && letter != '\r')
            cells.back() += letter == ',' ? '.' : letter;
    }
    // "1, 2" and a tab at the end leave nothing behind them
    if (cells.size() > 1 && cells.back().empty())
        cells.pop_back();
    return cells;
}

} // namespace

std::span<const Builder> allBuilders()
{
    static const std::vector<Builder> table = [] {
        std::vector<Builder> all{// wings
                                 deltaKiteBuilder, diamondKiteBuilder, rectangularKiteBuilder,
                                 hangGliderBuilder,
                                 // canopies
                                 parachuteBuilder, crossParachuteBuilder,
                                 // cloth
                                 clothBuilder, poleFlagBuilder, bendingTestBuilder,
                                 // lines
                                 ropeBuilder, bridleBuilder, frameBuilder, stiffenedRodBuilder};
        const std::span<const Builder> obstacles = obstacleBuilders();
        all.insert(all.end(), obstacles.begin(), obstacles.end());
        return all;
    }();
    return table;
}

const Builder* findBuilder(std::string_view name)
{
    for (const Builder& builder : allBuilders())
        if (builder.name == name)
            return &builder;
    return nullptr;
}

Result<Scene> build(const Builder& builder, const Parameters& given)
{
    Parameters all = unsaid(builder);
    for (const auto& [key, value] : given) {
        const Parameter* parameter = findParameter(builder, key);
        if (!parameter && !isCell(builder, key))
            return unknown(builder, key);
        if (const auto failure = parameter ? refused(*parameter, value) : std::nullopt)
            return *failure;
        all[key] = value;
    }
    if (builder.table)
        if (const auto failure = refused(*builder.table, tableOf(all, *builder.table)))
            return *failure;
    return builder.build(all);
}

Parameters unsaid(const Builder& builder)
{
    Parameters all;
    for (const Parameter& parameter : builder.parameters)
        all.emplace(parameter.key, parameter.initial);
    return all;
}

Parameters newDesign(const Builder& builder, const Parameters& given)
{
    Parameters all = given;
    if (const auto cloth = given.find("cloth"); cloth != given.end() && cloth->second == 0.0)
        return all;
    const auto isIdealBy = [&](std::string_view key) { // by a number that says so
        return std::ranges::any_of(builder.parameters, [&](const Parameter& parameter) {
            const auto number = given.find(std::string(parameter.key));
            return parameter.needs.key == key && parameter.needs.is == ParameterNeed::Is::Zero
                   && number != given.end() && number->second != parameter.atFirst();
        });
    };
    // Cloth that one can buy would collapse without the pressure that is not wanted then.
    for (const Parameter& parameter : builder.parameters)
        if (parameter.offered && parameter.choices.empty() && isIdealBy(parameter.key)
            && !given.contains(std::string(parameter.key)))
            return all;
    for (const Parameter& parameter : builder.parameters)
        if (parameter.offered && !isIdealBy(parameter.key))
            all.emplace(parameter.key, *parameter.offered);
    return all;
}

bool counts(const Parameter& parameter, std::span<const Parameter> all, const Parameters& values)
{
    const auto [key, is] = parameter.needs;
    const auto other = std::ranges::find(all, key, &Parameter::key);
    if (key.empty() || other == all.end())
        return true;
    const auto value = values.find(std::string(key));
    const bool isZero =
        !counts(*other, all, values) || (value != values.end() && value->second == 0.0);
    return isZero == (is == ParameterNeed::Is::Zero);
}

void setTable(Parameters& parameters, const TableParameter& table, const NumberRows& rows)
{
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < rows[row].size(); ++column)
            parameters[cellKey(table, row, column)] = rows[row][column];
}

NumberRows tableOf(const Parameters& parameters, const TableParameter& table)
{
    NumberRows rows;
    for (std::size_t row = 0; parameters.contains(cellKey(table, row, 0)); ++row) {
        rows.emplace_back();
        for (std::size_t column = 0;; ++column) {
            const auto cell = parameters.find(cellKey(table, row, column));
            if (cell == parameters.end())
                break;
            rows.back().push_back(cell->second);
        }
    }
    return rows;
}

Result<NumberRows> tableFromText(const TableParameter& table, std::string_view text)
{
    NumberRows rows;
    int line = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\n;"), text.size());
        std::string_view row = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line;
        if (row.find_first_not_of(" \t\r") == std::string_view::npos)
            continue; // a spreadsheet ends with an empty row
        std::vector<double> numbers;
        for (const std::string& cell : cellsOf(row)) {
            double value = 0.0;
            const auto [last, error] =
                std::from_chars(cell.data(), cell.data() + cell.size(), value);
            if (error != std::errc() || last != cell.data() + cell.size())
                return Failure("%1, row %2, column %3: \"%4\" is not a number.", table.key, line,
                               numbers.size() + 1, cell);
            numbers.push_back(value);
        }
        rows.push_back(std::move(numbers));
    }
    return rows;
}

} // namespace ripstop
