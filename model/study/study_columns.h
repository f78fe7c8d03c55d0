// A study as columns of numbers, one for each variable and for what was read of the flights: what
// pictures of many variables and the table of points show.
//
// Bands say how a reading is spread at each value of one variable, over whatever else varies there:
// seeds of gusts, or the other variables of a grid. Where nearly every point has a value of its
// own, neighbours are taken together.
#pragma once

#include "study/study_run.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

struct StudyColumn
{
    std::string title;               // with the unit
    std::vector<double> value;       // [points] not a number where there is none
    std::vector<std::string> labels; // of values that are no numbers; `value` is the place in it
    bool isLogarithmic = false;
};

StudyColumn variableColumn(const OpenedStudy& opened, std::size_t variable);

//   reading  of readingsOf(); nothing of a flight that did not end as it was meant
StudyColumn readingColumn(const OpenedStudy& opened, const StudyFlights& flights,
                          std::size_t reading);

std::string titleOf(const OpenedStudy& opened, const StudyVariable& variable); // with its unit
bool spreadsByLogarithm(const StudyVariable& variable);

// Of what is shown; nothing where nothing is.
struct ValueSpan
{
    double least;
    double largest;
};
std::optional<ValueSpan> spanOf(const std::vector<double>& values);

// The points whose values lie in all of these spans; a point without a value lies in none.
struct ColumnSpan
{
    std::size_t column;
    ValueSpan span;
};
std::vector<std::size_t> pointsIn(const std::vector<StudyColumn>& columns,
                                  const std::vector<ColumnSpan>& spans);

inline constexpr std::array bandPercents{5.0, 25.0, 50.0, 75.0, 95.0};

struct StudyBand
{
    double x = 0.0;                  // of the variable; the middle of those taken together
    std::vector<std::size_t> points; // of the study
    std::size_t counted = 0;         // of those, that have the reading
    std::size_t failed = 0;          // that ended early
    std::array<double, bandPercents.size()> value{}; // not numbers where nothing counted
};

// In ascending order of the variable; points that are not flown are in none.
std::vector<StudyBand> bandsOf(const StudyColumn& variable, const StudyColumn& reading,
                               const StudyFlights& flights);

} // namespace ripstop
