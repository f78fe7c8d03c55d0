// The points of a study: what each variable is in each of its flights.
//
// A point is a function of the study and its number alone, so that any number of machines can fly
// their share of a study without talking to each other, and a study that grows keeps what it has:
// grids keep their values, and the first points of Sobol' and Monte Carlo plans are those of the
// shorter ones. A Latin hypercube of another size has other points. The points of an optimisation
// follow from what was flown of it (study_search.h).
#pragma once

#include "base/result.h"
#include "study/study.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ripstop {

class StudyPoints
{
public:
    // Fails, naming the file or the plan, when the rows of points cannot be read or there are too
    // many points or variables.
    static Result<StudyPoints> of(const Study& study);

    std::size_t count() const { return m_count; }

    // The value of each variable, as --set takes it.
    std::vector<std::string> values(std::size_t point) const;
    std::string value(std::size_t point, std::size_t variable) const;

    // Another point of an optimisation, which has none until it asks for them.
    //   shares  [variables] of its range, 0 to 1
    void add(const std::vector<double>& shares);

private:
    std::string drawn(std::size_t variable, double share) const;
    double share(std::size_t point, std::size_t variable) const;

    Study m_study;
    std::size_t m_count = 0;
    std::vector<std::vector<std::string>> m_rows;     // of a file of points or an optimisation
    std::vector<std::vector<std::uint32_t>> m_strata; // [variables][points] of a Latin hypercube
};

// The point of a grid by the numbers of its values; the last variable changes fastest.
using GridPlace = std::vector<std::size_t>; // [variables]
std::size_t gridPoint(const Study& study, const GridPlace& place);

// The point of the sequence of Sobol' (1967) in this dimension, from 0 on, as a share of 2^32; the
// direction numbers are those of Joe and Kuo (2008).
inline constexpr std::size_t sobolDimensions = 20;
std::uint32_t sobolPoint(std::size_t point, std::size_t dimension);

// The same between 0 and 1, each digit shifted by the seed.
double shiftedSobolShare(std::size_t point, std::size_t dimension, std::uint64_t seed);

// Points of a plan of sensitivity that belong together: one of A, one of B, and for each variable
// that of A with this variable of B (Saltelli and others 2010).
std::size_t sensitivityBlock(std::size_t variables);

} // namespace ripstop
