// Percentiles are those of measures (measure.h); bandEnds() decides what is taken together.
#include "study/study_columns.h"

#include "scene/typed_number.h"
#include "study/point_scene.h"
#include "study/study_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace ripstop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest = 10; // points of a band of neighbours, for its percentiles

// Ends of the runs of points, in ascending order of their values, that make a band each.
std::vector<std::size_t> bandEnds(const std::vector<double>& sorted)
{
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i <= sorted.size(); ++i)
        if (i == sorted.size() || sorted[i] > sorted[i - 1])
            ends.push_back(i);
    const bool hasRepeats = 2 * ends.size() <= sorted.size();
    if (hasRepeats || sorted.size() < 2 * fewest)
        return ends;
    // as many bands as have about as many points each
    const auto bands = std::max<std::size_t>(
        2, std::min(sorted.size() / fewest, std::size_t(std::sqrt(double(sorted.size())))));
    ends.clear();
    for (std::size_t band = 1; band <= bands; ++band)
        ends.push_back(band * sorted.size() / bands);
    return ends;
}

StudyBand bandOf(const std::vector<std::size_t>& points, const StudyColumn& variable,
                 const StudyColumn& reading, const StudyFlights& flights)
{
    StudyBand band;
    band.points = points;
    band.x = 0.5 * (variable.value[points.front()] + variable.value[points.back()]);
    std::vector<double> values;
    for (const std::size_t point : points) {
        band.failed += outcomeOf(flights[point]) == FlightOutcome::Stopped;
        if (std::isfinite(reading.value[point]))
            values.push_back(reading.value[point]);
    }
    band.counted = values.size();
    for (std::size_t i = 0; i < bandPercents.size(); ++i)
        band.value[i] = percentileOf(values, bandPercents[i]);
    return band;
}

} // namespace

std::string titleOf(const OpenedStudy& opened, const StudyVariable& variable)
{
    const std::string unit = unitOf(opened.scene, variable.paths.front());
    return unit.empty() ? variable.name : variable.name + " (" + unit + ")";
}

bool spreadsByLogarithm(const StudyVariable& variable)
{
    return variable.spread
           && (variable.spread->kind == Distribution::Kind::Log
               || variable.spread->kind == Distribution::Kind::LogNormal);
}

StudyColumn variableColumn(const OpenedStudy& opened, std::size_t v)
{
    const StudyVariable& variable = opened.study.variables[v];
    StudyColumn column{titleOf(opened, variable), {}, {}, spreadsByLogarithm(variable)};
    const std::string unit = unitOf(opened.scene, variable.paths.front());
    std::map<std::string, double> known; // values that come again, or are no numbers
    const bool comesAgain = !opened.study.plan.draws() || !variable.spread;
    column.value.reserve(opened.points.count());
    for (std::size_t i = 0; i < opened.points.count(); ++i) {
        const std::string text = opened.points.value(i, v);
        if (const auto before = known.find(text); before != known.end()) {
            column.value.push_back(before->second);
            continue;
        }
        const auto number = typedValue(text, unit).number;
        const double value = number ? number->number : double(column.labels.size());
        if (!number)
            column.labels.push_back(text);
        if (!number || comesAgain)
            known.emplace(text, value);
        column.value.push_back(value);
    }
    return column;
}

StudyColumn readingColumn(const OpenedStudy& opened, const StudyFlights& flights,
                          std::size_t reading)
{
    StudyColumn column{readingsOf(opened)[reading], {}, {}, false};
    column.value.reserve(flights.size());
    for (const FlightResult* flight : flights)
        column.value.push_back(flight && !flight->endedEarly() ? readingOf(*flight, reading)
                                                               : nothing);
    return column;
}

std::optional<ValueSpan> spanOf(const std::vector<double>& values)
{
    std::optional<ValueSpan> span;
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        if (!span)
            span = ValueSpan{value, value};
        span->least = std::min(span->least, value);
        span->largest = std::max(span->largest, value);
    }
    return span;
}

std::vector<std::size_t> pointsIn(const std::vector<StudyColumn>& columns,
                                  const std::vector<ColumnSpan>& spans)
{
    std::vector<std::size_t> points;
    const std::size_t count = columns.empty() ? 0 : columns.front().value.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool isIn = std::ranges::all_of(spans, [&](const ColumnSpan& one) {
            const double value = columns[one.column].value[i];
            return value >= one.span.least && value <= one.span.largest;
        });
        if (isIn)
            points.push_back(i);
    }
    return points;
}

std::vector<StudyBand> bandsOf(const StudyColumn& variable, const StudyColumn& reading,
                               const StudyFlights& flights)
{
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (flights[i] && std::isfinite(variable.value[i]))
            points.push_back(i);
    std::ranges::stable_sort(points, {}, [&](std::size_t i) { return variable.value[i]; });
    std::vector<double> sorted;
    for (const std::size_t point : points)
        sorted.push_back(variable.value[point]);
    std::vector<StudyBand> bands;
    std::size_t first = 0;
    for (const std::size_t end : bandEnds(sorted)) {
        bands.push_back(
            bandOf({points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(end)},
                   variable, reading, flights));
        first = end;
    }
    return bands;
}

} // namespace ripstop
