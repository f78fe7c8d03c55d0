// mapOf() takes a grid apart by the values of its points and lays other points out by their
// numbers; below stand the lines that are drawn over a grid.
#include "study/study_map.h"

#include "scene/path.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace ripstop {
namespace {

constexpr std::array tearReadings{"first tear (s)", "first tear load (N or N/m)", "torn elements"};

std::string titleOf(const OpenedStudy& opened, const StudyVariable& variable)
{
    const auto place = findPlace(opened.scene, variable.paths.front());
    const std::string unit = place ? std::string(place->property->unit) : std::string();
    return unit.empty() ? variable.name : variable.name + " (" + unit + ")";
}

std::optional<double> numberOf(const std::string& value)
{
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    return end != value.c_str() && *end == '\0' ? std::optional(number) : std::nullopt;
}

bool spreadsByLogarithm(const StudyVariable& variable)
{
    return variable.spread
           && (variable.spread->kind == Distribution::Kind::Log
               || variable.spread->kind == Distribution::Kind::LogNormal);
}

// Where the values of one variable lie on an axis.
class Scale
{
public:
    Scale(const StudyVariable& variable, bool isGrid)
        : m_isGrid(isGrid)
    {
        for (std::size_t i = 0; i < variable.values.size(); ++i)
            m_place.emplace(variable.values[i], double(i));
    }

    double placeOf(const std::string& value)
    {
        if (!m_isGrid)
            if (const auto number = numberOf(value))
                return *number;
        return m_place.emplace(value, double(m_place.size())).first->second;
    }

private:
    bool m_isGrid;
    std::map<std::string, double> m_place;
};

bool isInSlice(const Study& study, const std::vector<std::string>& values, const MapChoice& choice)
{
    for (std::size_t v = 0; v < values.size(); ++v) {
        if (v == choice.x || v == choice.y)
            continue;
        const std::size_t place = v < choice.slice.size() ? choice.slice[v] : 0;
        if (values[v] != study.variables[v].values[place])
            return false;
    }
    return true;
}

StudyAxis axisOf(const OpenedStudy& opened, std::size_t v, bool isGrid)
{
    const StudyVariable& variable = opened.study.variables[v];
    StudyAxis axis{titleOf(opened, variable), {}, spreadsByLogarithm(variable)};
    if (isGrid)
        axis.labels = variable.values;
    return axis;
}

bool survived(const StudyMap::Point& point) { return point.outcome == FlightOutcome::Held; }

// The value of a cell that contours may use.
double valueOf(const StudyMap::Point& point)
{
    return point.outcome == FlightOutcome::Stopped ? std::nan("") : point.value;
}

} // namespace

StudyFlights flightsOf(const OpenedStudy& opened, const LedgerRows& rows)
{
    StudyFlights flights(opened.points.count(), nullptr);
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (const auto row = rows.find(opened.key(i)); row != rows.end())
            flights[i] = &row->second;
    return flights;
}

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

FlightOutcome outcomeOf(const FlightResult* flight)
{
    if (!flight)
        return FlightOutcome::Missing;
    if (flight->endedEarly())
        return FlightOutcome::Stopped;
    return flight->torn > 0 ? FlightOutcome::Torn : FlightOutcome::Held;
}

StudyMap mapOf(const OpenedStudy& opened, const StudyFlights& flights, const MapChoice& choice)
{
    const Study& study = opened.study;
    StudyMap map;
    map.isGrid = study.plan.isGrid();
    map.x = axisOf(opened, choice.x, map.isGrid);
    if (choice.y)
        map.y = axisOf(opened, *choice.y, map.isGrid);
    if (map.isGrid)
        map.points.resize(map.columns() * map.rows());
    Scale xScale(study.variables[choice.x], map.isGrid);
    Scale yScale(study.variables[choice.y.value_or(choice.x)], map.isGrid);
    for (std::size_t i = 0; i < flights.size(); ++i) {
        const std::vector<std::string> values = opened.points.values(i);
        if (map.isGrid && !isInSlice(study, values, choice))
            continue;
        StudyMap::Point point;
        point.number = i;
        point.x = xScale.placeOf(values[choice.x]);
        point.y = choice.y ? yScale.placeOf(values[*choice.y]) : 0.0;
        point.outcome = outcomeOf(flights[i]);
        if (flights[i]) {
            point.value = readingOf(*flights[i], choice.reading);
            point.isInaccurate = !flights[i]->inaccurate.empty();
        }
        if (map.isGrid)
            map.points[std::size_t(point.y) * map.columns() + std::size_t(point.x)] = point;
        else
            map.points.push_back(point);
    }
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
                value[c] = valueOf(map.points[(y + corner[c][1]) * columns + x + corner[c][0]]);
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
                std::ranges::rotate(crossing, crossing.begin() + 1);
            for (std::size_t i = 0; i + 1 < crossing.size(); i += 2)
                lines.push_back({crossing[i], crossing[i + 1]});
        }
    return lines;
}

std::vector<double> contourLevels(const StudyMap& map, int most)
{
    double least = std::numeric_limits<double>::infinity();
    double largest = -least;
    for (const StudyMap::Point& point : map.points)
        if (const double value = valueOf(point); std::isfinite(value)) {
            least = std::min(least, value);
            largest = std::max(largest, value);
        }
    if (!(largest > least))
        return {};
    // The next of 1, 2 and 5 times a power of ten that makes few enough.
    const double wish = (largest - least) / double(most);
    const double power = std::pow(10.0, std::floor(std::log10(wish)));
    double step = 10.0 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= wish)
            step = factor * power;
    std::vector<double> levels;
    for (double n = std::floor(least / step) + 1.0; n * step < largest; n += 1.0)
        levels.push_back(n * step);
    return levels;
}

} // namespace ripstop
