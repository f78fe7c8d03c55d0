#include "study/study_table.h"

#include "io/csv.h"
#include "io/json_text.h"

#include <cmath>

namespace ripstop {
namespace {

std::string header(const OpenedStudy& opened)
{
    std::string text = "# Ripstop " RIPSTOP_VERSION "; " + opened.study.scene + "; each until ";
    appendNumber(text, opened.plan.seconds);
    text += opened.plan.untilTear ? " s or its first tear\npoint" : " s\npoint";
    for (const StudyVariable& variable : opened.study.variables)
        text += ',' + csvCell(variable.name);
    text += ",time (s),steps,hash,torn links,first tear (s),first tear load,first "
            "torn,stopped,accuracy";
    for (const std::string& heading : opened.headings)
        text += ',' + csvCell(heading);
    return text + '\n';
}

std::string line(const OpenedStudy& opened, std::size_t point, const FlightResult& flight)
{
    std::string text = std::to_string(point);
    for (const std::string& value : opened.points.values(point))
        text += ',' + csvCell(value);
    appendCell(text, flight.time);
    text +=
        ',' + std::to_string(flight.steps) + ',' + flight.hash + ',' + std::to_string(flight.torn);
    appendCell(text, flight.firstTear);
    appendCell(text, flight.firstTearLoad);
    text += flight.torn > 0 ? ',' + std::to_string(flight.firstTorn) : ",";
    text += ',' + csvCell(flight.whyEarly()) + ',' + csvCell(flight.inaccurate);
    for (std::size_t i = 0; i < opened.headings.size(); ++i)
        appendCell(text, i < flight.measured.size() ? flight.measured[i] : std::nan(""));
    return text + '\n';
}

} // namespace

std::string studyTable(const OpenedStudy& opened, const StudyFlights& flights)
{
    std::string table = header(opened);
    for (std::size_t i = 0; i < flights.size(); ++i)
        if (flights[i])
            table += line(opened, i, *flights[i]);
    return table;
}

} // namespace ripstop
