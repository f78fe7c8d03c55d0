// Cells are made as texts, which the CSV joins and the database takes apart into numbers.
#include "study/study_table.h"

#include "base/program_version.h"
#include "io/csv.h"
#include "io/json_text.h"
#include "study/study_search.h"

#include <cmath>
#include <set>

namespace ripstop {
namespace {

std::vector<std::string> columnsOf(const OpenedStudy& opened)
{
    std::vector<std::string> columns{"point"};
    for (const StudyVariable& variable : opened.study.variables)
        columns.push_back(variable.name);
    for (const char* name :
         {"time (s)", "steps", "hash", "torn links", "first tear (s)", "first tear load",
          "unit of that load", "first torn", "stopped", "accuracy"})
        columns.emplace_back(name);
    columns.insert(columns.end(), opened.headings.begin(), opened.headings.end());
    const std::vector<std::string> titles = objectiveTitles(opened);
    columns.insert(columns.end(), titles.begin(), titles.end());
    if (!titles.empty())
        columns.insert(columns.end(), {"violation", "best"});
    return columns;
}

std::string numberCell(double value) { return std::isfinite(value) ? numberText(value) : ""; }

std::vector<std::string> rowOf(const OpenedStudy& opened, std::size_t point,
                               const FlightResult& flight, bool isBest)
{
    const auto measured = [&](std::size_t i) {
        return numberCell(i < flight.measured.size() ? flight.measured[i] : std::nan(""));
    };
    std::vector<std::string> row{std::to_string(point)};
    for (std::string& value : opened.points.values(point))
        row.push_back(std::move(value));
    row.insert(row.end(), {numberCell(flight.time), std::to_string(flight.steps), flight.hash,
                           std::to_string(flight.torn), numberCell(flight.firstTear),
                           numberCell(flight.firstTearLoad), flight.firstTearUnit,
                           flight.torn > 0 ? std::to_string(flight.firstTorn) : "",
                           flight.whyEarly(), flight.inaccurate});
    for (std::size_t i = 0; i < opened.headings.size(); ++i)
        row.push_back(measured(i));
    for (const std::size_t i : opened.wanted)
        row.push_back(measured(i));
    if (!opened.wanted.empty())
        row.insert(row.end(),
                   {numberCell(scoreOf(opened, flight).violation()), isBest ? "1" : "0"});
    return row;
}

std::string lineOf(const std::vector<std::string>& cells)
{
    std::string text;
    for (const std::string& cell : cells)
        text += (text.empty() ? "" : ",") + csvCell(cell);
    return text + '\n';
}

} // namespace

StudyTableRows studyTableRows(const OpenedStudy& opened, const StudyFlights& flights)
{
    const std::vector<std::size_t> best = bestPoints(opened, flights);
    const std::set<std::size_t> isBest(best.begin(), best.end());
    StudyTableRows table{columnsOf(opened), {}};
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (flights[i])
            table.rows.push_back(rowOf(opened, i, *flights[i], isBest.contains(i)));
    return table;
}

std::string studyTable(const OpenedStudy& opened, const StudyFlights& flights)
{
    std::string text =
        "# Ripstop " + programVersion() + "; " + opened.study.scene + "; each until ";
    appendNumber(text, opened.plan.seconds);
    text += opened.plan.untilTear ? " s or its first tear\n" : " s\n";
    const StudyTableRows table = studyTableRows(opened, flights);
    text += lineOf(table.columns);
    for (const std::vector<std::string>& row : table.rows)
        text += lineOf(row);
    return text;
}

} // namespace ripstop
