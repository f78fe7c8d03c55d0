// ripstop-cli study: run, status, merge, report and slurm; new is in study_new.cpp.
//
// run flies the points of its shard that no ledger has (study/study_run.h); the others look up the
// rows of all points.
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/study_line.h"
#include "cli/study_new.h"
#include "cli/targets.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "study/kept_runs.h"
#include "study/study_database.h"
#include "study/study_report.h"
#include "study/study_run.h"
#include "study/study_search.h"
#include "study/study_table.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <thread>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

std::string pointsText(std::size_t some, std::size_t all)
{
    return std::to_string(some) + " of " + std::to_string(all) + " points";
}

// The best so far, or how many make the front where there are several objectives; empty where
// nothing is wanted.
std::string bestText(const OpenedStudy& opened, const StudyFlights& flights)
{
    const std::vector<std::string> titles = objectiveTitles(opened);
    if (titles.empty())
        return {};
    const std::vector<std::size_t> best = bestPoints(opened, flights);
    std::string text = "best so far             ";
    if (best.empty())
        return text + "none that fulfils all constraints\n";
    if (titles.size() > 1)
        return text + std::to_string(best.size())
               + " on the Pareto front; study report lists them\n";
    text +=
        titles.front() + ": " + shortNumber(flights[best.front()]->measured[opened.wanted.front()]);
    for (const std::string& one : opened.assignments(best.front()))
        text += "\n                        " + one;
    return text + "\n";
}

// The recordings of the best, with what is wanted of each.
std::string keptText(const OpenedStudy& opened, const StudyFlights& flights,
                     const std::vector<std::size_t>& points)
{
    std::string text = "recordings kept         " + std::to_string(points.size()) + " of the best "
                       + std::to_string(opened.study.keepCount) + '\n';
    for (const std::size_t point : points) {
        text += "    " + keptRun(opened, point).string() + ':';
        for (const std::size_t measure : opened.wanted)
            text += ' ' + opened.headings[measure] + ' '
                    + shortNumber(flights[point]->measured[measure]) + ',';
        text.back() = '\n';
    }
    return text;
}

// What is flown or told of a design that was edited since flights of the study were flown. As it is
// it has none of these flights.
enum class EditedDesign { Refuse, Warn, AsItIs, AsItWas };

Result<OpenedStudy> openWith(const std::string& file, EditedDesign edited)
{
    auto opened = openStudy(file);
    if (!opened || edited == EditedDesign::AsItIs)
        return opened;
    const auto known = readLedgers(ledgerFolder(file));
    if (!known)
        return known.failure();
    const std::vector<std::string>& designs = known->designs;
    if (designs.empty() || std::ranges::find(designs, opened->keys.design()) != designs.end())
        return opened;
    const std::string scene = opened->sceneFile.string();
    if (edited != EditedDesign::AsItWas) {
        const Failure asked("%1 was edited since this study was flown. study run --anew flies it "
                            "anew as it is now, with --keep the study goes on with the design as "
                            "it was.",
                            scene);
        if (edited == EditedDesign::Refuse)
            return asked;
        warn(asked.message.english());
        return opened;
    }
    auto before = openStudy(file, keptDesign(ledgerFolder(file), designs.back()));
    if (before && before->keys.design() != designs.back())
        return Failure("%1 was edited since this study was flown, and so were the files that it "
                       "names; it cannot be flown as it was.",
                       scene);
    return before;
}

int runStudy(const std::string& file, const std::string& shardText, int jobs, EditedDesign edited)
{
    Shard shard;
    if (!shardText.empty()) {
        char rest = 0;
        unsigned long place = 0, count = 0;
        if (std::sscanf(shardText.c_str(), "%lu/%lu%c", &place, &count, &rest) != 2 || place < 1
            || place > count)
            return fail(WrongUsage,
                        "--shard " + shardText + ": write K/N, like 3/8 for the third of eight.");
        shard = {place - 1, count};
    }
    auto opened = openWith(file, edited);
    if (!opened)
        return fail(BadInput, opened.message());
    std::vector<std::string> paths;
    for (const StudyVariable& variable : opened->study.variables)
        paths.insert(paths.end(), variable.paths.begin(), variable.paths.end());
    tellIdle(opened->scene, file, paths);
    StudyLine line(*opened);
    const auto flown = flyMissing(
        *opened, shard, jobs, [&] { return line.isInterrupted(); },
        [&](const FlightNews& news) { line.tell(news); },
        [&](std::size_t done, std::size_t wanted) { line.tellRecorded(done, wanted); });
    line.end();
    if (!flown)
        return fail(BadInput, flown.message());
    const StudyTally& tally = flown->tally;
    if (tally.flown < flown->planned)
        return fail(Interrupted, "Interrupted; " + pointsText(tally.flown, flown->planned)
                                     + " of this run are flown and kept. Run it again to go on.");
    const bool isWaiting = flown->ofOthers > 0 && opened->study.plan.isSearch();
    if (isWaiting)
        std::cerr << "The search needs " << flown->ofOthers
                  << " points of other shards next. Run this one again when they are flown.\n";
    if (tally.flown == 0 && !isWaiting)
        std::cerr << "All points are flown already.\n";
    else
        std::cerr << "Flown: " << tally.flown << "; something tore in " << tally.torn << ", "
                  << tally.stopped << " ended early, " << tally.inaccurate
                  << " missed the accuracy.\n";
    if (opened->wanted.empty())
        return Done; // a hundred thousand rows are not read again for nothing
    const auto known = readLedgers(ledgerFolder(file));
    if (!known)
        return fail(BadInput, known.message());
    followSearch(*opened, known->rows);
    const StudyFlights flights = flightsOf(*opened, known->rows);
    std::cerr << bestText(*opened, flights);
    if (!flown->best)
        return Done;
    std::cerr << keptText(*opened, flights, *flown->best);
    if (interrupted())
        return fail(Interrupted, "Interrupted; the recordings of others that are best are missing. "
                                 "Run it again to go on.");
    return Done;
}

// --- status and merge ---------------------------------------------------------------------------

// A point with what is wanted of it.
nlohmann::json designJson(const OpenedStudy& opened, const StudyFlights& flights, std::size_t point)
{
    nlohmann::json set, wanted;
    const std::vector<std::string> values = opened.points.values(point);
    for (std::size_t v = 0; v < values.size(); ++v)
        set[opened.study.variables[v].name] = values[v];
    const std::vector<std::string> titles = objectiveTitles(opened);
    for (std::size_t i = 0; i < titles.size(); ++i)
        wanted[titles[i]] = flights[point]->measured[opened.wanted[i]];
    return {{"point", point}, {"values", set}, {"objectives", wanted}};
}

int status(const std::string& file, bool json, EditedDesign edited)
{
    auto opened = openWith(file, edited);
    if (!opened)
        return fail(BadInput, opened.message());
    const auto known = readLedgers(ledgerFolder(file));
    if (!known)
        return fail(BadInput, known.message());
    followSearch(*opened, known->rows);
    const StudyFlights flights = flightsOf(*opened, known->rows);
    const auto [flown, torn, stopped, inaccurate] = tallyOf(flights);
    const std::size_t all = opened->points.count();
    const std::size_t missing = countOf(missingPoints(*opened, flights));
    const bool isFrontier = opened->study.plan.kind == StudyPlan::Kind::Frontier;
    if (json) {
        nlohmann::json best = nlohmann::json::array();
        for (const std::size_t point : bestPoints(*opened, flights))
            best.push_back(designJson(*opened, flights, point));
        print({{"points", all},
               {"best", best},
               {"flown", flown},
               {"missing", missing},
               {"torn", torn},
               {"stopped", stopped},
               {"inaccurate", inaccurate},
               {"tornLines", known->torn},
               {"ofAnotherBuild", known->other.rows},
               {"differing", known->differing}});
        return Done;
    }
    std::cout << "points                  " << all << "\nflown                   " << flown
              << "\nmissing                 " << missing
              << (isFrontier && missing > 0 ? " next, along the frontier" : "")
              << (isFrontier && missing == 0 ? ": the frontier is found" : "")
              << (opened->optimiser && missing > 0 ? " next" : "")
              << (opened->optimiser && missing == 0 ? ": the search is over" : "")
              << "\nsomething tore in       " << torn << "\nended early             " << stopped
              << "\nmissed the accuracy     " << inaccurate << '\n'
              << bestText(*opened, flights);
    if (known->torn > 0)
        std::cout << "lines left out          " << known->torn << ", which a killed run tore\n";
    if (known->other.rows > 0)
        std::cout << "of another build        " << known->other.rows << ", by "
                  << known->other.program << ": they stay, and are flown anew\n";
    if (known->differing > 0)
        std::cout << "flown twice, unlike     " << known->differing << '\n';
    return Done;
}

// Makes files of what is known of a study: `write` gets that and says how it ends.
using WriteKnown = std::function<int(const OpenedStudy&, const StudyFlights&)>;
int withKnown(const std::string& file, EditedDesign edited, const std::vector<std::string>& targets,
              const WriteKnown& write)
{
    auto opened = openWith(file, edited);
    if (!opened)
        return fail(BadInput, opened.message());
    const FileNames inputs =
        inputsOf(opened->scene, opened->sceneFile.string(), {file, opened->controlsFile.string()});
    if (const int code = refuseTargets(targets, inputs); code != Done)
        return code;
    const auto known = readLedgers(ledgerFolder(file));
    if (!known)
        return fail(BadInput, known.message());
    followSearch(*opened, known->rows);
    const StudyFlights flights = flightsOf(*opened, known->rows);
    if (!known->rows.empty() && tallyOf(flights).flown == 0) // a file may tell of those
        return fail(BadInput, "None of the " + std::to_string(known->rows.size())
                                  + " flights kept beside " + file
                                  + " is of a point as study, files and program are now; nothing "
                                    "was written. Fly it with study run.");
    return write(*opened, flights);
}

// To the file, or to standard output without one.
int writeText(const std::string& output, const std::string& text)
{
    if (output.empty())
        std::cout << text;
    else if (const auto failure = replaceFile(output, text))
        return fail(BadInput, failure->message);
    return Done;
}

int merge(const std::string& file, EditedDesign edited, const std::string& output,
          const std::string& database)
{
    return withKnown(
        file, edited, {output, database},
        [&](const OpenedStudy& opened, const StudyFlights& flights) {
            if (!database.empty())
                if (const auto failure = writeStudyDatabase(opened, flights, database))
                    return fail(BadInput, failure->message);
            const bool wantsTable = database.empty() || !output.empty();
            if (wantsTable)
                if (const int code = writeText(output, studyTable(opened, flights)); code != Done)
                    return code;
            std::cerr << "The table has "
                      << pointsText(tallyOf(flights).flown, opened.points.count()) << ".\n";
            if (opened.study.keep == KeptRuns::Best)
                std::cerr << keptText(opened, flights, removeOvertaken(opened, flights));
            return int(Done);
        });
}

int report(const std::string& file, EditedDesign edited, const std::string& output, bool isHtml)
{
    return withKnown(file, edited, {output},
                     [&](const OpenedStudy& opened, const StudyFlights& flights) {
                         const auto format = isHtml ? ReportFormat::Html : ReportFormat::Markdown;
                         return writeText(output, studyReport(opened, flights, format));
                     });
}

// --- slurm --------------------------------------------------------------------------------------

// For a shell, whatever is in the name.
std::string quoted(const fs::path& path)
{
    std::string text = "'";
    for (const char c : path.string())
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

// A job array whose tasks fly a shard each. Slurm tells a task before its time is over; it ends in
// order then, keeps what it has, and stands in the queue again.
int slurm(const std::string& file, int tasks, const std::string& time)
{
    if (const auto opened = openStudy(file); !opened)
        return fail(BadInput, opened.message());
    std::error_code error;
    const fs::path place = fs::absolute(file, error);
    const std::string study = quoted(place);
    const std::string folder = ledgerFolder(place).string();
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const std::string program = quoted(error ? fs::path("ripstop-cli") : self);
    std::cout << "#!/bin/bash\n"
                 "# Flies a study in shards: sbatch this file. When the array is done:\n"
                 "#   ripstop-cli study merge "
              << study
              << " -o TABLE.csv\n"
                 "#SBATCH --job-name=ripstop-study\n"
                 "#SBATCH --array=1-"
              << tasks << "\n#SBATCH --time=" << time
              << "\n"
                 "#SBATCH --cpus-per-task=1\n"
                 "#SBATCH --requeue\n"
                 "#SBATCH --signal=B:TERM@60\n"
                 "#SBATCH --open-mode=append\n"
                 "#SBATCH --output="
              << folder
              << "-%a.log\n"
                 "trap 'kill -TERM $flight' TERM\n"
              << program << " study run " << study << " --shard $SLURM_ARRAY_TASK_ID/" << tasks
              << " --jobs ${SLURM_CPUS_PER_TASK:-1} &\n"
                 "flight=$!\n"
                 "wait $flight; code=$?\n"
                 "while kill -0 $flight 2>/dev/null; do wait $flight; code=$?; done\n"
                 "# ended by a signal: what is missing is flown later, or on another node\n"
                 "if ((code > 128 && ${SLURM_RESTART_COUNT:-0} < 100)); then\n"
                 "    scontrol requeue ${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID\n"
                 "fi\n"
                 "exit $code\n";
    return Done;
}

void addStudyFile(CLI::App& command, std::string& file)
{
    command.add_option("STUDY", file, "The study, *.ripstop-study.json")->required();
}

} // namespace

void addStudy(CLI::App& app, Command& chosen)
{
    CLI::App* study = app.add_subcommand(
        "study",
        "Fly a design with many values, on all cores or a cluster; what is flown is kept.");
    study->require_subcommand(1);
    // Before its own commands, which take it over.
    study->footer(
        "A study that is run again flies only what is missing: points that were added, or "
        "whose flights\nwere killed. Rows are kept beside the study in "
        "NAME.ripstop-runs, a line each.\n\n"
        "Example:\n"
        "  ripstop-cli study new s.ripstop-study.json --scene scenes/delta_kite.ripstop.json "
        "\\\n"
        "      --vary settings.airDensity=1.0:0.1:1.3 --vary \"wind.velocity=6,0,0; 8,0,0\"\n"
        "  ripstop-cli study run s.ripstop-study.json\n"
        "  ripstop-cli study merge s.ripstop-study.json -o kite.csv");
    addStudyNew(*study, chosen);

    struct Options
    {
        std::string file, shard, output, database, time = "01:00:00";
        int jobs = int(std::max(1u, std::thread::hardware_concurrency()));
        int tasks = 8;
        bool json = false;
        bool isHtml = false;
        bool keeps = false;
        bool isAnew = false;

        // Where the design was edited, nothing is flown, and no file written over one that may
        // tell of the design as it was, until it is said of which.
        EditedDesign edited(EditedDesign otherwise = EditedDesign::Refuse) const
        {
            if (keeps)
                return EditedDesign::AsItWas;
            return isAnew ? EditedDesign::AsItIs : otherwise;
        }
    };
    const auto options = std::make_shared<Options>();
    const auto addKeep = [&](CLI::App& command) {
        return command.add_flag("--keep", options->keeps,
                                "Of a design that was edited since: as it was when it was flown");
    };
    CLI::App* run = study->add_subcommand("run", "Fly what is missing.");
    addStudyFile(*run, options->file);
    run->add_option("--jobs", options->jobs, "Flights at a time; all cores without")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    run->add_option("--shard", options->shard, "Only the K-th of N shares of the points")
        ->type_name("K/N");
    run->add_flag("--anew", options->isAnew,
                  "A design that was edited since: all points of it anew")
        ->excludes(addKeep(*run));
    run->callback([options, &chosen] {
        chosen = [options] {
            return runStudy(options->file, options->shard, options->jobs, options->edited());
        };
    });

    CLI::App* told = study->add_subcommand("status", "Say how far it is.");
    addStudyFile(*told, options->file);
    told->add_flag("--json", options->json, "As a JSON object");
    addKeep(*told);
    told->callback([options, &chosen] {
        chosen = [options] {
            return status(options->file, options->json, options->edited(EditedDesign::Warn));
        };
    });

    CLI::App* merged = study->add_subcommand("merge", "Write one table of what all shards flew.");
    addStudyFile(*merged, options->file);
    merged->add_option("-o,--output", options->output, "The table, CSV; on standard output without")
        ->type_name("FILE");
    merged
        ->add_option("--sqlite", options->database,
                     "The same as a database of SQLite, with the tables flights and study")
        ->type_name("FILE");
    addKeep(*merged);
    merged->callback([options, &chosen] {
        chosen = [options] {
            return merge(options->file, options->edited(), options->output, options->database);
        };
    });

    CLI::App* reported = study->add_subcommand(
        "report", "Say what it came to: outcomes, measures, the best, and which variable matters.");
    addStudyFile(*reported, options->file);
    reported->add_option("-o,--output", options->output, "The report; on standard output without")
        ->type_name("FILE");
    reported->add_flag("--html", options->isHtml, "As a page of HTML instead of Markdown");
    addKeep(*reported);
    reported->callback([options, &chosen] {
        chosen = [options] {
            return report(options->file, options->edited(), options->output, options->isHtml);
        };
    });

    CLI::App* array =
        study->add_subcommand("slurm", "Print the script of a Slurm job array that flies it.");
    addStudyFile(*array, options->file);
    array->add_option("--tasks", options->tasks, "Shards")->check(CLI::Range(1, 100000));
    array->add_option("--time", options->time, "Time limit of each task, as sbatch takes it");
    array->callback([options, &chosen] {
        chosen = [options] { return slurm(options->file, options->tasks, options->time); };
    });
}

} // namespace ripstop
