// The points of a study: what each variable is in each of its flights.
//
// A point is a function of the study and its number alone, so that any number of machines can fly
// their share of a study without talking to each other, and a study that grows keeps what it has:
// grids keep their values, and the first points of Sobol' and Monte Carlo plans are those of the
// shorter ones. A Latin hypercube of another size has other points.
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

private:
    std::string drawn(std::size_t variable, double share) const;
    double share(std::size_t point, std::size_t variable) const;

    Study m_study;
    std::size_t m_count = 0;
    std::vector<std::vector<std::string>> m_rows;     // of a file of points
    std::vector<std::vector<std::uint32_t>> m_strata; // [variables][points] of a Latin hypercube
};

// The point of a grid by the numbers of its values; the last variable changes fastest.
using GridPlace = std::vector<std::size_t>; // [variables]
std::size_t gridPoint(const Study& study, const GridPlace& place);

// The point of the sequence of Sobol' (1967) in this dimension, from 0 on, as a share of 2^32; the
// direction numbers are those of Joe and Kuo (2008).
inline constexpr std::size_t sobolDimensions = 10;
std::uint32_t sobolPoint(std::size_t point, std::size_t dimension);

} // namespace ripstop
