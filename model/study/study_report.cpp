// studyReport() gathers blocks, which a printer for each format writes.
#include "study/study_report.h"

#include "base/program_version.h"
#include "study/study_map.h"
#include "study/study_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace ripstop {
namespace {

constexpr std::size_t mostDesigns = 50; // of a front
using ReportRow = std::vector<std::string>;

// A heading, a paragraph, or a table whose first row is its heading.
struct ReportBlock
{
    enum class Kind { Title, Heading, Text, Table };
    Kind kind;
    std::string text;
    std::vector<ReportRow> rows;
};
using ReportBlocks = std::vector<ReportBlock>;

std::string fourDigitText(double number)
{
    if (!std::isfinite(number))
        return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
}

std::string bandText(const ConfidenceBand& band)
{
    char text[96];
    std::snprintf(text, sizeof text, "%.3f (%.3f to %.3f)", band.value, band.low, band.high);
    return text;
}

// --- printers -----------------------------------------------------------------------------------

std::string replaced(std::string_view text, std::string_view special, const char* const* by)
{
    std::string all;
    for (const char c : text) {
        const std::size_t at = special.find(c);
        all += at == std::string_view::npos ? std::string(1, c) : std::string(by[at]);
    }
    return all;
}

std::string markdownCell(std::string_view text)
{
    constexpr const char* by[]{"\\|", " ", " "};
    return replaced(text, "|\n\r", by);
}

std::string htmlText(std::string_view text)
{
    constexpr const char* by[]{"&lt;", "&gt;", "&amp;", "&quot;"};
    return replaced(text, "<>&\"", by);
}

std::string markdown(const ReportBlocks& blocks)
{
    std::string text;
    for (const ReportBlock& block : blocks) {
        text += text.empty() ? "" : "\n";
        switch (block.kind) {
        case ReportBlock::Kind::Title:
            text += "# " + block.text + '\n';
            break;
        case ReportBlock::Kind::Heading:
            text += "## " + block.text + '\n';
            break;
        case ReportBlock::Kind::Text:
            text += block.text + '\n';
            break;
        case ReportBlock::Kind::Table:
            for (std::size_t i = 0; i < block.rows.size(); ++i) {
                for (const std::string& cell : block.rows[i])
                    text += "| " + markdownCell(cell) + ' ';
                text += "|\n";
                for (std::size_t k = 0; i == 0 && k < block.rows[0].size(); ++k)
                    text += k + 1 < block.rows[0].size() ? "|---" : "|---|\n";
            }
            break;
        }
    }
    return text;
}

std::string html(const ReportBlocks& blocks)
{
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>"
        + htmlText(blocks.front().text)
        + "</title>\n<style>body{font:15px sans-serif;max-width:60em;margin:2em auto;"
          "padding:0 1em}table{border-collapse:collapse}td,th{border:1px solid #aaa;"
          "padding:.2em .6em;text-align:left}</style>\n";
    for (const ReportBlock& block : blocks) {
        switch (block.kind) {
        case ReportBlock::Kind::Title:
            text += "<h1>" + htmlText(block.text) + "</h1>\n";
            break;
        case ReportBlock::Kind::Heading:
            text += "<h2>" + htmlText(block.text) + "</h2>\n";
            break;
        case ReportBlock::Kind::Text:
            text += "<p>" + htmlText(block.text) + "</p>\n";
            break;
        case ReportBlock::Kind::Table:
            text += "<table>\n";
            for (std::size_t i = 0; i < block.rows.size(); ++i) {
                text += "<tr>";
                for (const std::string& cell : block.rows[i])
                    text += (i == 0 ? "<th>" : "<td>") + htmlText(cell);
                text += '\n';
            }
            text += "</table>\n";
            break;
        }
    }
    return text + "</html>\n";
}

// --- sections -----------------------------------------------------------------------------------

std::string spreadText(const StudyVariable& variable)
{
    if (!variable.spread) {
        std::string text;
        for (const std::string& value : variable.values)
            text += (text.empty() ? "" : "; ") + value;
        return text;
    }
    const auto& [kind, a, b, c] = *variable.spread;
    const std::string first = fourDigitText(a), second = fourDigitText(b);
    switch (kind) {
    case Distribution::Kind::Uniform:
        return first + " to " + second;
    case Distribution::Kind::Log:
        return first + " to " + second + ", logarithmic";
    case Distribution::Kind::Normal:
        return "normal, mean " + first + ", deviation " + second;
    case Distribution::Kind::LogNormal:
        return "log-normal, median " + first + ", deviation " + second;
    case Distribution::Kind::Triangular:
        return "triangular, " + first + " to " + second + ", most at " + fourDigitText(c);
    }
    return {};
}

void addVariables(ReportBlocks& blocks, const OpenedStudy& opened)
{
    ReportBlock table{ReportBlock::Kind::Table, {}, {{"variable", "sets", "values"}}};
    for (const StudyVariable& variable : opened.study.variables) {
        std::string paths;
        for (const std::string& path : variable.paths)
            paths += (paths.empty() ? "" : ", ") + path;
        table.rows.push_back({variable.name, paths, spreadText(variable)});
    }
    blocks.push_back({ReportBlock::Kind::Heading, "Variables", {}});
    blocks.push_back(std::move(table));
}

void addOutcomes(ReportBlocks& blocks, const OpenedStudy& opened, const StudyFlights& flights)
{
    const StudyTally tally = tallyOf(flights);
    const auto held = std::size_t(std::ranges::count_if(flights, [](const FlightResult* flight) {
        return outcomeOf(flight) == FlightOutcome::Held;
    }));
    const auto row = [](const char* name, std::size_t count) {
        return ReportRow{name, std::to_string(count)};
    };
    blocks.push_back({ReportBlock::Kind::Heading, "Flights", {}});
    blocks.push_back({ReportBlock::Kind::Table,
                      {},
                      {{"outcome", "flights"},
                       row("points", flights.size()),
                       row("flown", tally.flown),
                       row("not flown", countOf(missingPoints(opened, flights))),
                       row("held", held),
                       row("something tore", tally.torn),
                       row("ended early", tally.stopped),
                       row("missed the accuracy", tally.inaccurate)}});
}

// Of the flights that ended as they were meant.
std::vector<double> numbersOf(const StudyFlights& flights, std::size_t reading)
{
    std::vector<double> numbers;
    for (const FlightResult* flight : flights)
        if (flight && !flight->endedEarly())
            if (const double value = readingOf(*flight, reading); std::isfinite(value))
                numbers.push_back(value);
    std::ranges::sort(numbers);
    return numbers;
}

void addMeasures(ReportBlocks& blocks, const OpenedStudy& opened, const StudyFlights& flights)
{
    ReportBlock table{
        ReportBlock::Kind::Table,
        {},
        {{"measure", "flights", "mean", "deviation", "least", "5 %", "median", "95 %", "largest"}}};
    const std::vector<std::string> readings = readingsOf(opened);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const std::vector<double> numbers = numbersOf(flights, i);
        if (numbers.empty())
            continue;
        const double count = double(numbers.size());
        const double mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / count;
        double squares = 0.0;
        for (const double one : numbers)
            squares += (one - mean) * (one - mean);
        ReportRow row{
            readings[i], std::to_string(numbers.size()), fourDigitText(mean),
            fourDigitText(count > 1.0 ? std::sqrt(squares / (count - 1.0)) : std::nan(""))};
        for (const double percent : {0.0, 5.0, 50.0, 95.0, 100.0})
            row.push_back(fourDigitText(percentileOf(numbers, percent)));
        table.rows.push_back(std::move(row));
    }
    blocks.push_back({ReportBlock::Kind::Heading, "Measures", {}});
    blocks.push_back({ReportBlock::Kind::Text,
                      "Of the flights that came to their end and have this number.",
                      {}});
    blocks.push_back(std::move(table));
}

void addBest(ReportBlocks& blocks, const OpenedStudy& opened, const StudyFlights& flights)
{
    const std::vector<std::string> titles = objectiveTitles(opened);
    if (titles.empty())
        return;
    const std::vector<std::size_t> best = bestPoints(opened, flights);
    blocks.push_back(
        {ReportBlock::Kind::Heading, titles.size() > 1 ? "Pareto front" : "Best design", {}});
    if (best.empty()) {
        blocks.push_back({ReportBlock::Kind::Text, "No flight fulfils all constraints.", {}});
        return;
    }
    if (best.size() > mostDesigns)
        blocks.push_back({ReportBlock::Kind::Text,
                          "The first " + std::to_string(mostDesigns) + " of "
                              + std::to_string(best.size()) + "; study merge has all.",
                          {}});
    ReportBlock table{ReportBlock::Kind::Table, {}, {{"point"}}};
    for (const StudyVariable& variable : opened.study.variables)
        table.rows.front().push_back(variable.name);
    for (const std::string& title : titles)
        table.rows.front().push_back(title);
    for (std::size_t i = 0; i < std::min(best.size(), mostDesigns); ++i) {
        ReportRow row{std::to_string(best[i])};
        for (const std::string& value : opened.points.values(best[i]))
            row.push_back(value);
        for (const std::size_t measure : opened.wanted)
            row.push_back(fourDigitText(flights[best[i]]->measured[measure]));
        table.rows.push_back(std::move(row));
    }
    blocks.push_back(std::move(table));
}

void addSensitivity(ReportBlocks& blocks, const OpenedStudy& opened, const StudyFlights& flights)
{
    if (opened.study.plan.kind != StudyPlan::Kind::Sensitivity)
        return;
    blocks.push_back({ReportBlock::Kind::Heading, "Sensitivity", {}});
    blocks.push_back({ReportBlock::Kind::Text,
                      "Indices of Sobol': first is the share of the variance that the variable "
                      "alone explains, total with all of its interactions; in brackets the band "
                      "of 95 % of the bootstrap.",
                      {}});
    const std::vector<std::string> readings = readingsOf(opened);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const Sensitivity found = sensitivityOf(opened, flights, i);
        if (found.variables.empty() || !(found.variance > 0.0))
            continue;
        ReportBlock table{ReportBlock::Kind::Table, {}, {{readings[i], "first", "total"}}};
        for (std::size_t v = 0; v < found.variables.size(); ++v)
            table.rows.push_back({opened.study.variables[v].name,
                                  bandText(found.variables[v].first),
                                  bandText(found.variables[v].total)});
        blocks.push_back(std::move(table));
        blocks.push_back({ReportBlock::Kind::Text,
                          "From " + std::to_string(found.blocks) + " blocks of flights; "
                              + std::to_string(found.leftOut)
                              + " are left out, as a flight of theirs is missing or has no number.",
                          {}});
    }
}

} // namespace

Sensitivity sensitivityOf(const OpenedStudy& opened, const StudyFlights& flights,
                          std::size_t reading)
{
    std::vector<double> values;
    for (const FlightResult* flight : flights)
        values.push_back(flight && !flight->endedEarly() ? readingOf(*flight, reading)
                                                         : std::nan(""));
    return sensitivityOf(values, opened.study.variables.size());
}

std::string studyReport(const OpenedStudy& opened, const StudyFlights& flights, ReportFormat format)
{
    const Study& study = opened.study;
    ReportBlocks blocks;
    blocks.push_back({ReportBlock::Kind::Title,
                      study.title.empty() ? opened.file.filename().string() : study.title,
                      {}});
    blocks.push_back({ReportBlock::Kind::Text,
                      "Ripstop " + programVersion() + "; " + study.scene + ", each flight until "
                          + fourDigitText(study.seconds) + " s"
                          + (study.untilTear ? " or its first tear" : "") + "; plan "
                          + std::string(choiceNames<StudyPlan::Kind>[std::size_t(study.plan.kind)])
                          + '.',
                      {}});
    addVariables(blocks, opened);
    addOutcomes(blocks, opened, flights);
    addBest(blocks, opened, flights);
    addMeasures(blocks, opened, flights);
    addSensitivity(blocks, opened, flights);
    return format == ReportFormat::Html ? html(blocks) : markdown(blocks);
}

} // namespace ripstop
