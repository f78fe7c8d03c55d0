// A study seen over one or two of its variables: what a picture of it shows.
//
// A grid is a map with a cell for each pair of values; where the study has more variables, the map
// is a slice through it, at one value of each of the others. Points of other plans lie where their
// numbers are. Values that are no numbers, such as vectors, stand side by side in their order.
#pragma once

#include "study/study_columns.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

// What a map may show of a flight: its measures, then these.
enum class TearReading { FirstTear, FirstTearLoad, Torn };
std::vector<std::string> readingsOf(const OpenedStudy& opened); // with units
double readingOf(const FlightResult& flight, std::size_t reading);

struct StudyAxis
{
    std::string title;               // name and unit of the variable
    std::vector<std::string> labels; // of the values of a grid
    bool isLogarithmic = false;      // where points lie by their numbers
};

struct StudyMap
{
    struct Point
    {
        std::size_t number = 0; // in the study
        double x = 0.0;         // number of the column of a grid, else the value
        double y = 0.0;         // row; 0 in a study of one variable
        double value = std::numeric_limits<double>::quiet_NaN();
        FlightOutcome outcome = FlightOutcome::Missing;
        bool isInaccurate = false; // it missed the wanted accuracy

        // What a picture shows of it: nothing of a flight that did not end as it was meant.
        double shown() const
        {
            return outcome == FlightOutcome::Stopped ? std::numeric_limits<double>::quiet_NaN()
                                                     : value;
        }
    };
    bool isGrid = false;
    StudyAxis x;
    std::optional<StudyAxis> y;
    std::vector<Point> points; // of a grid [y][x]

    std::size_t columns() const { return x.labels.size(); } // of a grid
    std::size_t rows() const { return y ? y->labels.size() : 1; }
};

struct MapChoice
{
    std::size_t x = 0;            // variable
    std::optional<std::size_t> y; // another one
    std::size_t reading = 0;      // of readingsOf()
    GridPlace slice;              // [variables] the value of each that is no axis, of a grid
};

StudyMap mapOf(const OpenedStudy& opened, const StudyFlights& flights, const MapChoice& choice);

// --- lines over a grid ---------------------------------------------------------------------------

struct MapSegment
{
    std::array<double, 2> from; // in columns and rows
    std::array<double, 2> to;
};

// Between cells that held and neighbours that tore or ended early: the tear line.
std::vector<MapSegment> frontier(const StudyMap& map);

// Where the value is `level`, straight between the middles of four cells (marching squares); cells
// that are not flown or did not end as meant have no value.
std::vector<MapSegment> contour(const StudyMap& map, double level);

std::optional<ValueSpan> valueSpan(const StudyMap& map); // of what is shown

// Round levels between the least and the largest value, at most `most`.
std::vector<double> contourLevels(const StudyMap& map, int most);

} // namespace ripstop
