// ripstop-cli study: new, run, status, merge and slurm.
//
// run flies the points of its shard that no ledger has (study/study_run.h); merge and status look
// up the rows of all points.
#include "cli/commands.h"
#include "cli/scene_input.h"
#include "cli/sweep_axes.h"
#include "cli/targets.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "study/point_scene.h"
#include "study/study_run.h"
#include "study/study_table.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

std::string pointsText(std::size_t some, std::size_t all)
{
    return std::to_string(some) + " of " + std::to_string(all) + " points";
}

int runStudy(const std::string& file, const std::string& shardText, int jobs)
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
    const auto opened = openStudy(file);
    if (!opened)
        return fail(BadInput, opened.message());
    ProgressLine progress("study");
    const auto flown = flyMissing(*opened, shard, jobs, interrupted,
                                  [&](std::size_t, const FlightResult&, const StudyFlown& now) {
                                      progress.show(double(now.tally.flown) / double(now.planned));
                                  });
    if (!flown)
        return fail(BadInput, flown.message());
    const StudyTally& tally = flown->tally;
    if (tally.flown < flown->planned)
        return fail(Interrupted, "Interrupted; " + pointsText(tally.flown, flown->planned)
                                     + " of this run are flown and kept. Run it again to go on.");
    const bool isWaiting =
        flown->ofOthers > 0 && opened->study.plan.kind == StudyPlan::Kind::Frontier;
    if (isWaiting)
        std::cerr << "The frontier needs " << flown->ofOthers
                  << " points of other shards next. Run this one again when they are flown.\n";
    if (tally.flown == 0 && !isWaiting)
        std::cerr << "All points are flown already.\n";
    else
        std::cerr << "Flown: " << tally.flown << "; something tore in " << tally.torn << ", "
                  << tally.stopped << " ended early, " << tally.inaccurate
                  << " missed the accuracy.\n";
    return Done;
}

// --- status and merge ---------------------------------------------------------------------------

int status(const std::string& file, bool json)
{
    const auto opened = openStudy(file);
    if (!opened)
        return fail(BadInput, opened.message());
    const auto known = readLedgers(ledgerFolder(file));
    if (!known)
        return fail(BadInput, known.message());
    const StudyFlights flights = flightsOf(*opened, known->rows);
    const auto [flown, torn, stopped, inaccurate] = tallyOf(flights);
    const std::size_t all = opened->points.count();
    const std::size_t missing = missingPoints(*opened, flights).size();
    const bool isSearch = opened->study.plan.kind == StudyPlan::Kind::Frontier;
    if (json) {
        print({{"points", all},
               {"flown", flown},
               {"missing", missing},
               {"torn", torn},
               {"stopped", stopped},
               {"inaccurate", inaccurate},
               {"tornLines", known->torn},
               {"differing", known->differing}});
        return Done;
    }
    std::cout << "points                  " << all << "\nflown                   " << flown
              << "\nmissing                 " << missing
              << (isSearch && missing > 0 ? " next, along the frontier" : "")
              << (isSearch && missing == 0 ? ": the frontier is found" : "")
              << "\nsomething tore in       " << torn << "\nended early             " << stopped
              << "\nmissed the accuracy     " << inaccurate << '\n';
    if (known->torn > 0)
        std::cout << "lines left out          " << known->torn << ", which a killed run tore\n";
    if (known->differing > 0)
        std::cout << "flown twice, unlike     " << known->differing << '\n';
    return Done;
}

int merge(const std::string& file, const std::string& output)
{
    const auto opened = openStudy(file);
    if (!opened)
        return fail(BadInput, opened.message());
    FileNames inputs =
        inputsOf(opened->scene, opened->sceneFile.string(), {file, opened->controlsFile.string()});
    if (const int code = refuseTargets({output}, inputs); code != Done)
        return code;
    const auto known = readLedgers(ledgerFolder(file));
    if (!known)
        return fail(BadInput, known.message());
    const StudyFlights flights = flightsOf(*opened, known->rows);
    const std::string table = studyTable(*opened, flights);
    if (output.empty())
        std::cout << table;
    else if (const auto failure = replaceFile(output, table))
        return fail(BadInput, failure->message);
    std::cerr << "The table has " << pointsText(tallyOf(flights).flown, opened->points.count())
              << ".\n";
    return Done;
}

// --- new and slurm ------------------------------------------------------------------------------

struct NewOptions
{
    std::string file, scene, plan = "grid";
    std::vector<std::string> vary; // "PATH+PATH=VALUES"
    double seconds = 10.0;
    std::int64_t count = 100;
    std::uint64_t seed = 1;
    bool untilTear = false;
};

// "a.x+b.x=1,2": several paths get the same value.
Result<StudyVariable> variableOf(const std::string& text)
{
    const auto axis = sweepAxis(text);
    if (!axis)
        return axis.failure();
    StudyVariable variable;
    variable.values = axis->values;
    for (std::size_t begin = 0; begin <= axis->path.size();) {
        const std::size_t end = std::min(axis->path.find('+', begin), axis->path.size());
        variable.paths.push_back(axis->path.substr(begin, end - begin));
        begin = end + 1;
    }
    variable.name = variable.paths.front();
    return variable;
}

int newStudy(const NewOptions& options)
{
    Study study;
    const fs::path folder = fs::absolute(options.file).parent_path();
    study.scene = fs::proximate(fs::absolute(options.scene), folder).generic_string();
    study.seconds = options.seconds;
    study.untilTear = options.untilTear;
    study.folder = folder;
    const auto kind = std::ranges::find(choiceNames<StudyPlan::Kind>, options.plan);
    study.plan.kind = StudyPlan::Kind(kind - choiceNames<StudyPlan::Kind>.begin());
    if (!study.plan.goesThroughValues()) {
        study.plan.count = options.count;
        study.plan.seed = options.seed;
    }
    for (const std::string& text : options.vary) {
        auto variable = variableOf(text);
        if (!variable)
            return fail(WrongUsage, variable.message());
        study.variables.push_back(std::move(*variable));
    }
    if (const int code = refuseTargets({options.file}, {options.scene}); code != Done)
        return code;
    const std::string text = studyText(study);
    if (const auto again = studyOf(text); !again) // what cannot be read is not written
        return fail(WrongUsage, "The study " + again.message().english() + ".");
    const auto scene = readScene(options.scene);
    if (!scene)
        return fail(BadInput, scene.message());
    for (const StudyVariable& variable : study.variables)
        for (const std::string& path : variable.paths)
            for (const std::string& value : variable.values)
                if (const auto failure = checkAssignment(*scene, path + '=' + value))
                    return fail(WrongUsage, failure->message);
    if (const auto failure = replaceFile(options.file, text))
        return fail(BadInput, failure->message);
    return Done;
}

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

void addNew(CLI::App& study, Command& chosen)
{
    CLI::App* command = study.add_subcommand("new", "Write the file of a study.");
    const auto options = std::make_shared<NewOptions>();
    command->add_option("STUDY", options->file, "The file, *.ripstop-study.json")->required();
    command->add_option("--scene", options->scene, "The scene that is flown")->required();
    command
        ->add_option("--vary", options->vary,
                     "A property and its values, as of sweep; PATH+PATH=VALUES gives several the "
                     "same value")
        ->required()
        ->type_name("PATH=VALUES")
        ->allow_extra_args(false);
    std::vector<std::string> kinds;
    for (const auto& kind : choiceNames<StudyPlan::Kind>)
        if (kind != choiceNames<StudyPlan::Kind>[std::size_t(StudyPlan::Kind::Points)])
            kinds.emplace_back(kind);
    command->add_option("--plan", options->plan, "How the points come from the values")
        ->check(CLI::IsMember(kinds));
    command->add_option("--count", options->count, "Points of a plan that draws them")
        ->check(CLI::Range(std::int64_t(1), std::int64_t(mostStudyPoints)));
    command->add_option("--seed", options->seed, "Of what is drawn");
    command->add_option("--seconds", options->seconds, "Simulated time of each flight, s")
        ->check(numberBetween(0.0, 1e9))
        ->type_name("T");
    command->add_flag("--until-tear", options->untilTear, "End a flight with its first tear");
    command->callback([options, &chosen] { chosen = [options] { return newStudy(*options); }; });
}

} // namespace

void addStudy(CLI::App& app, Command& chosen)
{
    CLI::App* study = app.add_subcommand(
        "study",
        "Fly a design with many values, on all cores or a cluster; what is flown is kept.");
    study->require_subcommand(1);
    addNew(*study, chosen);

    struct Options
    {
        std::string file, shard, output, time = "01:00:00";
        int jobs = int(std::max(1u, std::thread::hardware_concurrency()));
        int tasks = 8;
        bool json = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* run = study->add_subcommand("run", "Fly what is missing.");
    addStudyFile(*run, options->file);
    run->add_option("--jobs", options->jobs, "Flights at a time; all cores without")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    run->add_option("--shard", options->shard, "Only the K-th of N shares of the points")
        ->type_name("K/N");
    run->callback([options, &chosen] {
        chosen = [options] { return runStudy(options->file, options->shard, options->jobs); };
    });

    CLI::App* told = study->add_subcommand("status", "Say how far it is.");
    addStudyFile(*told, options->file);
    told->add_flag("--json", options->json, "As a JSON object");
    told->callback([options, &chosen] {
        chosen = [options] { return status(options->file, options->json); };
    });

    CLI::App* merged = study->add_subcommand("merge", "Write one table of what all shards flew.");
    addStudyFile(*merged, options->file);
    merged->add_option("-o,--output", options->output, "The table, CSV; on standard output without")
        ->type_name("FILE");
    merged->callback([options, &chosen] {
        chosen = [options] { return merge(options->file, options->output); };
    });

    CLI::App* array =
        study->add_subcommand("slurm", "Print the script of a Slurm job array that flies it.");
    addStudyFile(*array, options->file);
    array->add_option("--tasks", options->tasks, "Shards")->check(CLI::Range(1, 100000));
    array->add_option("--time", options->time, "Time limit of each task, as sbatch takes it");
    array->callback([options, &chosen] {
        chosen = [options] { return slurm(options->file, options->tasks, options->time); };
    });

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
}

} // namespace ripstop
