// ripstop-cli verify: every case whose answer is known, got beside expected; and what designs do
// beside what was measured of real ones.
//
// In order: tables and JSON of results; runAll(), which ends at Ctrl-C with what it has; the
// comparisons with measured data, where nothing can fail; and the cases, whose failures decide the
// exit code.
#include "base/program_version.h"
#include "cli/commands.h"
#include "terminal/terminal.h"
#include "verify/case.h"
#include "verify/reference.h"
#include "verify/text.h"

#include <algorithm>
#include <iostream>

namespace ripstop {
namespace {

struct VerifyOptions
{
    std::string filter;
    bool list = false;
    bool references = false;
    bool json = false;
};

using TextRow = std::vector<std::string>;

// Pads all columns but the last one to the width of their widest cell.
void printTable(const std::vector<TextRow>& rows)
{
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const TextRow& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            width[i] = std::max(width[i], row[i].size());
    for (const TextRow& row : rows) {
        if (row.size() == 1) { // the title of a section
            std::cout << '\n' << row[0] << '\n';
            continue;
        }
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += i + 1 < row.size() ? row[i] + std::string(width[i] + 2 - row[i].size(), ' ')
                                       : row[i];
        std::cout << line << '\n';
    }
}

void printResults(const std::vector<CaseResult>& results)
{
    std::vector<TextRow> rows{
        {"holds", "id", "case", "expected", "got", "unit", "tolerance", "source"}};
    std::string section;
    for (const CaseResult& result : results) {
        if (result.section != section)
            rows.push_back({section = result.section});
        rows.push_back({result.holds ? "yes" : "NO", result.id, result.title,
                        digits(result.expected), digits(result.got), result.unit,
                        textOf(result.tolerance, result.unit), result.source});
    }
    printTable(rows);
}

Json jsonOf(const CaseResult& result)
{
    constexpr const char* rules[]{"absolute", "relative", "at_most", "at_least"};
    return {{"id", result.id},
            {"section", result.section},
            {"title", result.title},
            {"expected", result.expected},
            {"got", result.got},
            {"tolerance", result.tolerance.value},
            {"tolerance_rule", rules[std::size_t(result.tolerance.rule)]},
            {"unit", result.unit},
            {"source", result.source},
            {"holds", result.holds},
            {"seconds", result.seconds}};
}

void printJson(const std::vector<CaseResult>& results, std::size_t failed, double seconds)
{
    Json list = Json::array();
    for (const CaseResult& result : results)
        list.push_back(jsonOf(result));
    print({{"version", programVersion()},
           {"cases", results.size()},
           {"hold", results.size() - failed},
           {"do_not_hold", failed},
           {"seconds", seconds},
           {"results", std::move(list)}});
}

void listCases(const std::vector<Case>& cases)
{
    std::vector<TextRow> rows{{"id", "case", "expected", "unit", "tolerance", "source"}};
    for (const Case& one : cases)
        rows.push_back({one.id, one.title, digits(one.expected), one.unit,
                        textOf(one.tolerance, one.unit), one.source});
    printTable(rows);
}

// Runs all, or as many as there is time for until Ctrl-C, and returns their results.
template <typename Result, typename One>
std::vector<Result> runAll(const std::vector<One>& all)
{
    std::vector<Result> results;
    ProgressLine progress("verifying");
    for (const One& one : all) {
        progress.show(double(results.size()) / double(all.size()));
        if (interrupted())
            break;
        results.push_back(run(one));
    }
    return results;
}

int stopped(std::size_t done, std::size_t all)
{
    return fail(Interrupted,
                "Interrupted after " + std::to_string(done) + " of " + std::to_string(all) + ".");
}

int nothingHas(const std::string& filter)
{
    return fail(WrongUsage, "Nothing has \"" + filter
                                + "\" in its id, title, section or source; "
                                  "\"ripstop-cli verify --list\" lists all cases.");
}

// --- comparisons with measured data --------------------------------------------------------------

void printReferences(const std::vector<ReferenceResult>& results)
{
    std::vector<TextRow> rows{
        {"comparison", "published", "got", "unit", "ratio", "published by", "simulated as"}};
    std::string section;
    for (const ReferenceResult& result : results) {
        if (result.section != section)
            rows.push_back({section = result.section});
        rows.push_back({result.title, publishedText(result.low, result.high), gotText(result),
                        result.unit, ratioText(result), result.source, result.note});
    }
    printTable(rows);
    std::cout << "\nA ratio of 1 is the middle of what was published. No row is tuned.\n";
}

Json jsonOf(const ReferenceResult& result)
{
    return {{"section", result.section}, {"title", result.title},    {"low", result.low},
            {"high", result.high},       {"got", result.got},        {"ratio", result.ratio},
            {"inside", result.inside},   {"unit", result.unit},      {"source", result.source},
            {"note", result.note},       {"seconds", result.seconds}};
}

void listReferences(const std::vector<Reference>& references)
{
    std::vector<TextRow> rows{{"comparison", "published", "unit", "published by", "simulated as"}};
    for (const Reference& one : references)
        rows.push_back(
            {one.title, publishedText(one.low, one.high), one.unit, one.source, one.note});
    printTable(rows);
}

int compare(const VerifyOptions& options)
{
    const std::vector<Reference> references = referencesWith(options.filter);
    if (references.empty())
        return nothingHas(options.filter);
    if (options.list) {
        listReferences(references);
        return Done;
    }
    const auto results = runAll<ReferenceResult>(references);
    if (options.json) {
        Json list = Json::array();
        for (const ReferenceResult& result : results)
            list.push_back(jsonOf(result));
        print({{"version", programVersion()}, {"references", std::move(list)}});
    } else if (!results.empty()) {
        printReferences(results);
    }
    return results.size() < references.size() ? stopped(results.size(), references.size()) : Done;
}

// --- cases ---------------------------------------------------------------------------------------

int verify(const VerifyOptions& options)
{
    if (options.references)
        return compare(options);
    const std::vector<Case> cases = casesWith(options.filter);
    if (cases.empty())
        return nothingHas(options.filter);
    if (options.list) {
        listCases(cases);
        return Done;
    }
    const auto results = runAll<CaseResult>(cases);
    double seconds = 0.0;
    for (const CaseResult& result : results)
        seconds += result.seconds;
    const auto failed = std::size_t(std::count_if(results.begin(), results.end(),
                                                  [](const CaseResult& r) { return !r.holds; }));
    if (options.json)
        printJson(results, failed, seconds);
    else if (!results.empty())
        printResults(results);
    if (results.size() < cases.size())
        return stopped(results.size(), cases.size());
    if (failed > 0)
        return fail(BadInput, std::to_string(failed) + " of " + std::to_string(cases.size())
                                  + " cases do not hold.");
    if (!options.json)
        std::cout << "\nAll " << cases.size() << " cases hold (" << shortNumber(seconds)
                  << " s).\n";
    return Done;
}

} // namespace

void addVerify(CLI::App& app, Command& chosen)
{
    CLI::App* command = app.add_subcommand(
        "verify", "Run the cases whose answer is known; got beside expected, with the source.");
    const auto options = std::make_shared<VerifyOptions>();
    command->add_option("--filter", options->filter,
                        "Only cases with this text in id, title, section or source");
    command->add_flag("--references", options->references,
                      "Instead, compare designs with measured data: descent, glide, kites");
    CLI::Option* list =
        command->add_flag("--list", options->list, "List the cases without running them");
    command->add_flag("--json", options->json, "Print one JSON object")->excludes(list);
    command->footer("Exit code 0 when all cases hold, 1 when some do not.\n"
                    "Examples:\n"
                    "  ripstop-cli verify\n"
                    "  ripstop-cli verify --filter pendulum\n"
                    "  ripstop-cli verify --filter T-K2 --json\n"
                    "  ripstop-cli verify --references");
    command->callback([options, &chosen] { chosen = [options] { return verify(*options); }; });
}

} // namespace ripstop
