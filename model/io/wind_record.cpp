// The header says which columns are meant; each row then gives a time and numbers, from which a
// velocity is made at the end, when the mean direction is known.
#include "io/wind_record.h"

#include "base/number_table.h"
#include "io/whole_file.h"
#include "scene/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ripstop {
namespace {

enum class Form { Speed, Direction, Axes, Sonic };

struct Column
{
    std::size_t place = 0;
    double factor = 1.0; // to s, m/s or degrees
};

// The time, then what the form has: one, two or three numbers.
struct Columns
{
    Form form = Form::Speed;
    std::vector<Column> all;
    std::size_t count = 0; // cells of a row
};

constexpr double degree = std::numbers::pi / 180.0;

using Words = std::span<const std::string_view>;

class Header
{
public:
    Header(const TableLine& line, std::string_view name)
        : m_line(line)
        , m_name(name)
    {
        for (const std::string& cell : line.cells)
            m_cells.push_back(nameAndUnit(cell));
    }

    bool has(Words words) const { return find(words) < m_cells.size(); }

    // Where it is and what its unit makes of it; fails where that is none of this kind.
    Result<Column> column(Words words, std::string_view unit) const
    {
        const std::size_t place = find(words);
        if (place == m_cells.size())
            return Failure("%1, line %2: The header names no column for the %3; write \"time "
                           "(s),speed (m/s)\" for example.",
                           m_name, m_line.number, Message::word(words.front()));
        const std::string& given = m_cells[place].second;
        const auto factor = unitFactor(given, unit);
        if (!factor)
            return Failure("%1, line %2: \"%3\" is no unit for the %4; write %5.", m_name,
                           m_line.number, given, Message::word(words.front()), unit);
        return Column{place, *factor};
    }

private:
    std::size_t find(Words words) const
    {
        const auto found = std::ranges::find_if(m_cells, [&](const auto& cell) {
            return std::ranges::find(words, cell.first) != words.end();
        });
        return std::size_t(found - m_cells.begin());
    }

    const TableLine& m_line;
    std::string_view m_name;
    std::vector<std::pair<std::string, std::string>> m_cells; // name and unit
};

// What columns may be called, what they are first.
constexpr std::array<std::string_view, 3> timeWords{"time", "t", "elapsed time"};
constexpr std::array<std::string_view, 4> speedWords{"speed", "wind speed", "wind", "ws"};
constexpr std::array<std::string_view, 4> directionWords{"direction", "wind direction", "dir",
                                                         "wd"};
constexpr std::string_view axisLetters = "xyz"; // a column each
constexpr std::string_view sonicLetters = "uvw";

Result<Columns> columnsOf(const TableLine& line, std::string_view name)
{
    const Header header(line, name);
    Columns columns;
    columns.count = line.cells.size();
    std::array<std::string_view, 3> letters;
    std::vector<std::pair<Words, std::string_view>> wanted = {{timeWords, "s"}};
    const auto wantsEach = [&](std::string_view names) { // where there is the first of them
        for (std::size_t i = 0; i < letters.size(); ++i)
            letters[i] = names.substr(i, 1);
        if (!header.has(Words(letters).first(1)))
            return false;
        for (std::size_t i = 0; i < letters.size(); ++i)
            wanted.push_back({Words(letters).subspan(i, 1), "m/s"});
        return true;
    };
    if (wantsEach(axisLetters)) {
        columns.form = Form::Axes;
    } else if (wantsEach(sonicLetters)) {
        columns.form = Form::Sonic;
    } else {
        wanted.push_back({speedWords, "m/s"});
        if (header.has(directionWords)) {
            columns.form = Form::Direction;
            wanted.push_back({directionWords, "deg"});
        }
    }
    for (const auto& [words, unit] : wanted) {
        const Result<Column> column = header.column(words, unit);
        if (!column)
            return column.failure();
        columns.all.push_back(*column);
    }
    return columns;
}

Result<Columns> columnsWithoutHeader(const TableLine& line, std::string_view name)
{
    const std::size_t count = line.cells.size();
    if (count != 2 && count != 4)
        return Failure(
            "%1, line %2: Begin with a line that names the columns, like \"time (s),speed "
            "(m/s),direction (deg)\"; without one there are two, time and speed, or "
            "four, time, x, y and z.",
            name, line.number);
    Columns columns;
    columns.form = count == 2 ? Form::Speed : Form::Axes;
    columns.count = count;
    for (std::size_t i = 0; i < count; ++i)
        columns.all.push_back({i, 1.0});
    return columns;
}

// Radians, of all the way that the wind has gone by rows of time, speed and direction.
double meanDirection(const NumberRows& rows)
{
    double north = 0.0;
    double east = 0.0;
    for (const std::vector<double>& row : rows) {
        north += row[1] * std::cos(row[2] * degree);
        east += row[1] * std::sin(row[2] * degree);
    }
    return std::atan2(east, north);
}

NumberRows velocitiesOf(const NumberRows& rows, Form form)
{
    const double mean = form == Form::Direction ? meanDirection(rows) : 0.0;
    NumberRows velocities;
    for (const std::vector<double>& row : rows) {
        switch (form) {
        case Form::Speed:
            velocities.push_back({row[0], row[1], 0.0, 0.0});
            break;
        case Form::Direction: { // clockwise from above is from +x towards +z
            const double turned = row[2] * degree - mean;
            velocities.push_back(
                {row[0], row[1] * std::cos(turned), 0.0, row[1] * std::sin(turned)});
            break;
        }
        case Form::Axes:
            velocities.push_back(row);
            break;
        case Form::Sonic:
            velocities.push_back({row[0], row[1], row[3], -row[2]});
            break;
        }
    }
    return velocities;
}

} // namespace

Result<NumberRows> readWindRecord(std::string_view text, std::string_view name)
{
    std::vector<TableLine> lines = tableLines(text);
    if (lines.empty())
        return Failure("%1 has no rows.", name);
    const bool hasHeader = isHeader(lines.front());
    const Result<Columns> columns =
        hasHeader ? columnsOf(lines.front(), name) : columnsWithoutHeader(lines.front(), name);
    if (!columns)
        return columns.failure();
    if (hasHeader)
        lines.erase(lines.begin());
    NumberRows rows;
    for (const TableLine& line : lines) {
        if (line.cells.size() != columns->count)
            return Failure("%1, line %2: It has %3 cells instead of %4; decimals are written with "
                           "a point.",
                           name, line.number, line.cells.size(), columns->count);
        if (std::ranges::any_of(columns->all, [&](const Column& column) {
                return line.cells[column.place].empty();
            }))
            continue;
        std::vector<double>& row = rows.emplace_back();
        for (const Column& column : columns->all) {
            const Result<double> number = numberAt(line, column.place, name);
            if (!number)
                return number.failure();
            row.push_back(*number * column.factor);
        }
        if (rows.size() > 1 && row[0] <= rows[rows.size() - 2][0])
            return Failure("%1, line %2: Its time does not come after that of the row before; "
                           "times are seconds that rise.",
                           name, line.number);
    }
    if (rows.empty())
        return Failure("%1 has no rows.", name);
    return velocitiesOf(rows, columns->form);
}

Result<NumberRows> windRecordOf(const std::filesystem::path& file)
{
    const Result<std::string> text =
        readWholeFile(file, [](std::string_view) { return std::optional<Message>(); });
    if (!text)
        return text.failure();
    return readWindRecord(*text, file.string());
}

} // namespace ripstop
