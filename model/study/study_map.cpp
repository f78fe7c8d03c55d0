// mapOf() finds the points of a grid by their places and lays other points out by their numbers;
// below stand the lines that are drawn over a grid.
#include "study/study_map.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::array tearReadings{"first tear (s)", "first tear load (N or N/m)", "torn elements"};

StudyAxis axisOf(const OpenedStudy& opened, std::size_t v, bool isGrid)
{
    const StudyVariable& variable = opened.study.variables[v];
    StudyAxis axis{titleOf(opened, variable), {}, spreadsByLogarithm(variable)};
    if (isGrid)
        axis.labels = variable.values;
    return axis;
}

bool survived(const StudyMap::Point& point) { return point.outcome == FlightOutcome::Held; }

} // namespace

std::vector<std::string> readingsOf(const OpenedStudy& opened)
{
    std::vector<std::string> all = opened.headings;
    all.insert(all.end(), tearReadings.begin(), tearReadings.end());
    return all;
}

double readingOf(const FlightResult& flight, std::size_t reading)
{
    const std::size_t measures = flight.measured.size();
    if (reading < measures)
        return flight.measured[reading];
    switch (TearReading(reading - measures)) {
    case TearReading::FirstTear:
        return flight.firstTear;
    case TearReading::FirstTearLoad:
        return flight.firstTearLoad;
    case TearReading::Torn:
        return double(flight.torn);
    }
    return std::nan("");
}

StudyMap mapOf(const OpenedStudy& opened, const StudyFlights& flights, const MapChoice& choice)
{
    const Study& study = opened.study;
    StudyMap map;
    map.isGrid = study.plan.isGrid();
    map.x = axisOf(opened, choice.x, map.isGrid);
    if (choice.y)
        map.y = axisOf(opened, *choice.y, map.isGrid);
    const auto add = [&](std::size_t number, double x, double y) {
        const FlightResult* flight = flights[number];
        StudyMap::Point& point = map.points.emplace_back();
        point.number = number;
        point.x = x;
        point.y = y;
        point.outcome = outcomeOf(flight);
        if (flight) {
            point.value = readingOf(*flight, choice.reading);
            point.isInaccurate = !flight->inaccurate.empty();
        }
    };
    if (map.isGrid) {
        GridPlace place = choice.slice;
        place.resize(study.variables.size(), 0);
        for (std::size_t row = 0; row < map.rows(); ++row)
            for (std::size_t column = 0; column < map.columns(); ++column) {
                place[choice.x] = column;
                if (choice.y)
                    place[*choice.y] = row;
                add(gridPoint(study, place), double(column), double(row));
            }
        return map;
    }
    const StudyColumn x = variableColumn(opened, choice.x);
    const StudyColumn y = choice.y ? variableColumn(opened, *choice.y) : StudyColumn();
    for (std::size_t i = 0; i < flights.size(); ++i)
        add(i, x.value[i], choice.y ? y.value[i] : 0.0);
    return map;
}

std::vector<MapSegment> frontier(const StudyMap& map)
{
    std::vector<MapSegment> lines;
    if (!map.isGrid)
        return lines;
    const auto differ = [](const StudyMap::Point& a, const StudyMap::Point& b) {
        return a.outcome != FlightOutcome::Missing && b.outcome != FlightOutcome::Missing
               && survived(a) != survived(b);
    };
    const std::size_t columns = map.columns();
    for (std::size_t y = 0; y < map.rows(); ++y)
        for (std::size_t x = 0; x < columns; ++x) {
            const StudyMap::Point& here = map.points[y * columns + x];
            const double right = double(x) + 0.5;
            const double above = double(y) + 0.5;
            if (x + 1 < columns && differ(here, map.points[y * columns + x + 1]))
                lines.push_back({{right, above - 1.0}, {right, above}});
            if (y + 1 < map.rows() && differ(here, map.points[(y + 1) * columns + x]))
                lines.push_back({{right - 1.0, above}, {right, above}});
        }
    return lines;
}

std::vector<MapSegment> contour(const StudyMap& map, double level)
{
    std::vector<MapSegment> lines;
    const std::size_t columns = map.columns();
    for (std::size_t y = 0; map.isGrid && y + 1 < map.rows(); ++y)
        for (std::size_t x = 0; x + 1 < columns; ++x) {
            // the corners of the square, round it
            static constexpr std::array<std::array<std::size_t, 2>, 4> corner{
                {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
            std::array<double, 4> value{};
            for (std::size_t c = 0; c < 4; ++c)
                value[c] = map.points[(y + corner[c][1]) * columns + x + corner[c][0]].shown();
            if (!std::ranges::all_of(value, [](double one) { return std::isfinite(one); }))
                continue;
            std::vector<std::array<double, 2>> crossing; // of its four sides, in their order
            for (std::size_t c = 0; c < 4; ++c) {
                const std::size_t next = (c + 1) % 4;
                if ((value[c] < level) == (value[next] < level))
                    continue;
                const double part = (level - value[c]) / (value[next] - value[c]);
                const auto between = [&](std::size_t axis) {
                    return double(corner[c][axis])
                           + part * (double(corner[next][axis]) - double(corner[c][axis]));
                };
                crossing.push_back({double(x) + between(0), double(y) + between(1)});
            }
            // A saddle has four: its middle says whether the first corner stands alone.
            const double middle = (value[0] + value[1] + value[2] + value[3]) / 4.0;
            if (crossing.size() == 4 && (middle < level) != (value[0] < level))
                std::rotate(crossing.begin(), crossing.begin() + 1, crossing.end());
            for (std::size_t i = 0; i + 1 < crossing.size(); i += 2)
                lines.push_back({crossing[i], crossing[i + 1]});
        }
    return lines;
}

std::optional<ValueSpan> valueSpan(const StudyMap& map)
{
    std::vector<double> values;
    for (const StudyMap::Point& point : map.points)
        values.push_back(point.shown());
    return spanOf(values);
}

std::vector<double> contourLevels(const StudyMap& map, int most)
{
    const auto span = valueSpan(map);
    if (!span || !(span->largest > span->least))
        return {};
    // The next of 1, 2 and 5 times a power of ten that makes few enough.
    const double wish = (span->largest - span->least) / double(most);
    const double power = std::pow(10.0, std::floor(std::log10(wish)));
    double step = 10.0 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= wish)
            step = factor * power;
    std::vector<double> levels;
    for (double n = std::floor(span->least / step) + 1.0; n * step < span->largest; n += 1.0)
        levels.push_back(n * step);
    return levels;
}

} // namespace ripstop
