// of() counts the points and makes what they need of it; values() is a case for each kind of plan.
// Shares are between 0 and 1 and hit neither, since quantiles of a normal distribution do not end
// there.
#include "study/plan.h"

#include "io/csv.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "study/random_share.h"

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

using PlanKind = StudyPlan::Kind;

constexpr double tailLeftOut = 0.001; // of a distribution without ends, by an optimisation

// The numbers below `count` in random order (Fisher and Yates 1938).
std::vector<std::uint32_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t variable)
{
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[randomBits(seed ^ 0x5bf0'3635, i, variable) % i]);
    return order;
}

std::vector<std::string_view> cellsOf(std::string_view line)
{
    std::vector<std::string_view> cells;
    bool isQuoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"')
            isQuoted = !isQuoted;
        if (i == line.size() || (line[i] == ',' && !isQuoted)) {
            cells.push_back(cellContent(line.substr(begin, i - begin)));
            begin = i + 1;
        }
    }
    return cells;
}

std::vector<std::string_view> linesOf(std::string_view text) // without comments and empty ones
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        if (!line.empty() && line.front() != '#')
            lines.push_back(line);
    }
    return lines;
}

// The rows of a file with a column for each variable, others are left out.
Result<std::vector<std::vector<std::string>>> readPoints(const Study& study)
{
    const std::filesystem::path file = study.folder / study.plan.file;
    const auto text =
        readWholeFile(file, [](std::string_view) { return std::optional<Message>(); });
    if (!text)
        return text.failure();
    const std::vector<std::string_view> lines = linesOf(*text);
    if (lines.empty())
        return Failure("%1 has no points; its first line names the variables.", file.string());
    const std::vector<std::string_view> heading = cellsOf(lines.front());
    std::vector<std::size_t> column;
    for (const StudyVariable& variable : study.variables) {
        const auto found = std::ranges::find(heading, variable.name);
        if (found == heading.end())
            return Failure("%1 has no column that is called %2; its first line names the "
                           "variables of the study.",
                           file.string(), variable.name);
        column.push_back(std::size_t(found - heading.begin()));
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::vector<std::string_view> cells = cellsOf(lines[i]);
        std::vector<std::string>& row = rows.emplace_back();
        for (std::size_t k = 0; k < column.size(); ++k) {
            if (column[k] >= cells.size() || cells[column[k]].empty())
                return Failure("%1: row %2 has no value for %3.", file.string(), i,
                               study.variables[k].name);
            row.emplace_back(cells[column[k]]);
        }
    }
    return rows;
}

double countOf(const Study& study)
{
    double count = 1.0;
    for (const StudyVariable& variable : study.variables) {
        if (study.plan.isGrid())
            count *= double(variable.values.size());
        else if (study.plan.kind == PlanKind::OneAtATime)
            count += double(variable.values.size()) - 1.0;
    }
    if (study.plan.kind == PlanKind::Optimise)
        return 0.0; // they come as it goes
    const double blocks = double(study.plan.count);
    if (study.plan.kind == PlanKind::Sensitivity)
        return blocks * double(sensitivityBlock(study.variables.size()));
    return study.plan.goesThroughValues() ? count : blocks;
}

} // namespace

Result<StudyPoints> StudyPoints::of(const Study& study)
{
    StudyPoints points;
    points.m_study = study;
    const double count = countOf(study);
    if (count > mostStudyPoints)
        return Failure("The plan has %1 points; a study has up to %2.",
                       Message::number("%.4g", count), Message::number("%.4g", mostStudyPoints));
    points.m_count = std::size_t(count);
    if (study.plan.kind == PlanKind::Points) {
        auto rows = readPoints(study);
        if (!rows)
            return rows.failure();
        points.m_rows = std::move(*rows);
        points.m_count = points.m_rows.size();
    }
    const std::size_t variables = study.variables.size();
    if (study.plan.kind == PlanKind::Sobol && variables > sobolDimensions)
        return Failure("A plan of Sobol' has up to %1 variables, and this study %2; take "
                       "latin_hypercube.",
                       sobolDimensions, variables);
    if (study.plan.kind == PlanKind::Sensitivity && 2 * variables > sobolDimensions)
        return Failure("A plan of sensitivity has up to %1 variables, and this study %2.",
                       sobolDimensions / 2, variables);
    if (study.plan.kind == PlanKind::LatinHypercube)
        for (std::size_t v = 0; v < study.variables.size(); ++v)
            points.m_strata.push_back(shuffled(points.m_count, study.plan.seed, v));
    return points;
}

double StudyPoints::share(std::size_t point, std::size_t variable) const
{
    const std::uint64_t bits = randomBits(m_study.plan.seed, point, variable);
    switch (m_study.plan.kind) {
    case PlanKind::LatinHypercube:
        return (double(m_strata[variable][point]) + shareOf(bits)) / double(m_count);
    case PlanKind::Sobol:
        return shiftedSobolShare(point, variable, m_study.plan.seed);
    case PlanKind::Sensitivity: { // A, B, then A with one variable of B after the other
        const std::size_t variables = m_study.variables.size();
        const std::size_t block = sensitivityBlock(variables);
        const std::size_t row = point % block;
        const bool isOfB = row == 1 || row == variable + 2;
        return shiftedSobolShare(point / block, variable + (isOfB ? variables : 0),
                                 m_study.plan.seed);
    }
    default:
        return shareOf(bits);
    }
}

std::string StudyPoints::drawn(std::size_t variable, double share) const
{
    const StudyVariable& one = m_study.variables[variable];
    if (one.spread)
        return numberText(quantile(*one.spread, share));
    const std::size_t count = one.values.size();
    return one.values[std::min(std::size_t(share * double(count)), count - 1)];
}

void StudyPoints::add(const std::vector<double>& shares)
{
    std::vector<std::string>& row = m_rows.emplace_back();
    for (std::size_t v = 0; v < shares.size(); ++v) {
        const auto& spread = m_study.variables[v].spread;
        const bool hasNoEnds = spread
                               && (spread->kind == Distribution::Kind::Normal
                                   || spread->kind == Distribution::Kind::LogNormal);
        const double margin = hasNoEnds ? tailLeftOut : 0.0;
        row.push_back(drawn(v, std::clamp(shares[v], margin, 1.0 - margin)));
    }
    m_count = m_rows.size();
}

std::vector<std::string> StudyPoints::values(std::size_t point) const
{
    if (m_study.plan.kind == PlanKind::Points || m_study.plan.kind == PlanKind::Optimise)
        return m_rows[point];
    std::vector<std::string> all;
    for (std::size_t v = 0; v < m_study.variables.size(); ++v)
        all.push_back(value(point, v));
    return all;
}

std::string StudyPoints::value(std::size_t point, std::size_t variable) const
{
    if (m_study.plan.kind == PlanKind::Points || m_study.plan.kind == PlanKind::Optimise)
        return m_rows[point][variable];
    const std::vector<StudyVariable>& variables = m_study.variables;
    const std::vector<std::string>& values = variables[variable].values;
    if (m_study.plan.isGrid()) { // as gridPoint() has it
        for (std::size_t v = variables.size(); --v > variable;)
            point /= variables[v].values.size();
        return values[point % values.size()];
    }
    if (m_study.plan.kind == PlanKind::OneAtATime) {
        std::size_t first = 1; // point of the variable's second value
        for (std::size_t v = 0; v < variable; ++v)
            first += variables[v].values.size() - 1;
        const bool isIts = point >= first && point < first + values.size() - 1;
        return values[isIts ? point - first + 1 : 0];
    }
    return drawn(variable, share(point, variable));
}

std::size_t gridPoint(const Study& study, const GridPlace& place)
{
    std::size_t point = 0;
    for (std::size_t v = 0; v < place.size(); ++v)
        point = point * study.variables[v].values.size() + place[v];
    return point;
}

double shiftedSobolShare(std::size_t point, std::size_t dimension, std::uint64_t seed)
{
    const std::uint64_t shift = randomBits(seed ^ 0x50b0'1234, 0, dimension) >> 32;
    const std::uint32_t place = sobolPoint(point, dimension) ^ std::uint32_t(shift);
    return (double(place) + 0.5) / 4294967296.0;
}

std::size_t sensitivityBlock(std::size_t variables) { return variables + 2; }

// Gray code as of Antonov and Saleev 1979 would need the point before; this needs none.
std::uint32_t sobolPoint(std::size_t point, std::size_t dimension)
{
    struct Direction // of a primitive polynomial of this degree
    {
        int degree;
        std::uint32_t coefficients;
        std::uint32_t start[7];
    };
    constexpr Direction directions[sobolDimensions - 1]{{1, 0, {1}},
                                                        {2, 1, {1, 3}},
                                                        {3, 1, {1, 3, 1}},
                                                        {3, 2, {1, 1, 1}},
                                                        {4, 1, {1, 1, 3, 3}},
                                                        {4, 4, {1, 3, 5, 13}},
                                                        {5, 2, {1, 1, 5, 5, 17}},
                                                        {5, 4, {1, 1, 5, 5, 5}},
                                                        {5, 7, {1, 1, 7, 11, 19}},
                                                        {5, 11, {1, 1, 5, 1, 1}},
                                                        {5, 13, {1, 1, 1, 3, 11}},
                                                        {5, 14, {1, 3, 5, 5, 31}},
                                                        {6, 1, {1, 3, 3, 9, 7, 49}},
                                                        {6, 13, {1, 1, 1, 15, 21, 21}},
                                                        {6, 16, {1, 3, 1, 13, 27, 49}},
                                                        {6, 19, {1, 1, 1, 15, 7, 5}},
                                                        {6, 22, {1, 3, 1, 15, 13, 25}},
                                                        {6, 25, {1, 1, 5, 5, 19, 61}},
                                                        {7, 1, {1, 3, 7, 11, 23, 15, 103}}};
    std::uint32_t value[32]; // direction numbers
    for (int i = 0; i < 32; ++i) {
        if (dimension == 0) {
            value[i] = 1u << (31 - i);
            continue;
        }
        const Direction& direction = directions[dimension - 1];
        const int s = direction.degree;
        if (i < s) {
            value[i] = direction.start[i] << (31 - i);
            continue;
        }
        value[i] = value[i - s] ^ (value[i - s] >> s);
        for (int k = 1; k < s; ++k)
            if ((direction.coefficients >> (s - 1 - k)) & 1u)
                value[i] ^= value[i - k];
    }
    std::uint32_t place = 0;
    for (int i = 0; i < 32 && (point >> i) != 0; ++i)
        if ((point >> i) & 1u)
            place ^= value[i];
    return place;
}

} // namespace ripstop
