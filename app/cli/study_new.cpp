// A study from options: what varies, how the points come of that, and what is wanted.
#include "cli/study_new.h"

#include "cli/scene_input.h"
#include "cli/sweep_axes.h"
#include "cli/targets.h"
#include "io/csv.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "study/opened_study.h"
#include "study/polish.h"
#include "study/study.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <filesystem>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

struct NewOptions
{
    std::string file, scene, plan = "grid";
    std::vector<std::string> vary; // "PATH+PATH=VALUES"
    double seconds = 10.0;
    std::int64_t count = 100;
    std::int64_t population = 16;
    std::int64_t generations = 20;
    std::int64_t polish = Polish::isThere() ? 40 : 0;
    std::uint64_t seed = 1;
    bool untilTear = false;
    bool replaces = false;
    std::vector<std::string> minimise, maximise;      // "PROBE REDUCTION"
    std::vector<std::string> target, atMost, atLeast; // "PROBE REDUCTION=NUMBER"
    bool noTear = false;
    bool accurate = false;
};

// "1500..24000", and "log" behind it where it spreads by even factors; nothing where it is no
// range.
std::optional<StudyVariable> rangeOf(std::string text)
{
    constexpr std::string_view log = " log";
    const bool isLogarithmic = text.ends_with(log);
    if (isLogarithmic)
        text.resize(text.size() - log.size());
    const std::size_t dots = text.find("..");
    const auto from = cellNumber(text.substr(0, dots));
    const auto to = cellNumber(text.substr(std::min(dots, text.size() - 2) + 2));
    if (dots == std::string::npos || !from || !to)
        return std::nullopt;
    return rangeVariable(*from, *to, 0, isLogarithmic);
}

// "a.x+b.x=1,2": several paths get the same value.
Result<StudyVariable> variableOf(const std::string& text)
{
    const auto axis = sweepAxis(text);
    if (!axis)
        return axis.failure();
    StudyVariable variable;
    variable.values = axis->values;
    if (axis->values.size() == 1)
        if (auto range = rangeOf(axis->values.front()))
            variable = std::move(*range);
    for (std::size_t begin = 0; begin <= axis->path.size();) {
        const std::size_t end = std::min(axis->path.find('+', begin), axis->path.size());
        variable.paths.push_back(axis->path.substr(begin, end - begin));
        begin = end + 1;
    }
    variable.name = variable.paths.front();
    return variable;
}

// "line angle mean", or "line angle mean from 2", in seconds; its final value without a reduction.
Measure measureOf(std::string text)
{
    Measure measure;
    constexpr std::string_view from = " from ";
    if (const std::size_t at = text.rfind(from); at != std::string::npos)
        if (const auto seconds = cellNumber(text.substr(at + from.size()))) {
            measure.from = *seconds;
            text.resize(at);
        }
    const std::size_t space = text.rfind(' ');
    const std::string last = space == std::string::npos ? std::string() : text.substr(space + 1);
    const auto reduction = std::ranges::find(choiceNames<Reduction>, last);
    if (reduction != choiceNames<Reduction>.end()) {
        measure.reduction = Reduction(reduction - choiceNames<Reduction>.begin());
        text.resize(space);
    }
    measure.probe = text;
    return measure;
}

struct Bound
{
    Measure measure;
    double number;
};

// "line tension max=60"
Result<Bound> boundOf(const std::string& text)
{
    const std::size_t equals = text.rfind('=');
    const auto number =
        equals == std::string::npos ? std::nullopt : cellNumber(text.substr(equals + 1));
    if (!number)
        return Failure("%1: write PROBE REDUCTION=NUMBER, like \"line tension max=60\".", text);
    return Bound{measureOf(text.substr(0, equals)), *number};
}

// Objectives and constraints; the first that cannot be read.
std::optional<Failure> takeGoals(const NewOptions& options, Study& study)
{
    for (const std::string& text : options.minimise)
        study.objectives.push_back({measureOf(text), Goal::Minimise, 0.0});
    for (const std::string& text : options.maximise)
        study.objectives.push_back({measureOf(text), Goal::Maximise, 0.0});
    for (const std::string& text : options.target) {
        const auto bound = boundOf(text);
        if (!bound)
            return bound.failure();
        study.objectives.push_back({bound->measure, Goal::Target, bound->number});
    }
    using Kind = Constraint::Kind;
    for (const auto& [kind, texts] :
         {std::pair(Kind::AtMost, &options.atMost), std::pair(Kind::AtLeast, &options.atLeast)})
        for (const std::string& text : *texts) {
            const auto bound = boundOf(text);
            if (!bound)
                return bound.failure();
            study.constraints.push_back({kind, bound->measure, bound->number, {}});
        }
    if (options.noTear)
        study.constraints.push_back({Kind::Outcome, {}, 0.0, WantedOutcome::NoTear});
    if (options.accurate)
        study.constraints.push_back({Kind::Outcome, {}, 0.0, WantedOutcome::Accurate});
    return std::nullopt;
}

void takePlan(const NewOptions& options, Study& study)
{
    StudyPlan& plan = study.plan;
    const auto kind = std::ranges::find(choiceNames<StudyPlan::Kind>, options.plan);
    plan.kind = StudyPlan::Kind(kind - choiceNames<StudyPlan::Kind>.begin());
    plan.seed = options.seed;
    if (plan.draws())
        plan.count = options.count;
    if (plan.kind != StudyPlan::Kind::Optimise)
        return;
    const bool hasFront = study.objectives.size() > 1;
    plan.method = hasFront ? StudyPlan::Method::Nsga2 : StudyPlan::Method::ParticleSwarm;
    plan.population = options.population;
    plan.generations = options.generations;
    plan.polish = hasFront ? 0 : options.polish;
}

int newStudy(const NewOptions& options)
{
    Study study;
    const fs::path folder = fs::absolute(options.file).parent_path();
    study.scene = fs::proximate(fs::absolute(options.scene), folder).generic_string();
    study.seconds = options.seconds;
    study.untilTear = options.untilTear;
    study.folder = folder;
    if (const auto failure = takeGoals(options, study))
        return fail(WrongUsage, failure->message);
    takePlan(options, study);
    for (const std::string& text : options.vary) {
        auto variable = variableOf(text);
        if (!variable)
            return fail(WrongUsage, variable.message());
        study.variables.push_back(std::move(*variable));
    }
    if (const int code = refuseTargets({options.file}, {options.scene}); code != Done)
        return code;
    std::error_code ignored;
    if (!options.replaces && fs::is_regular_file(options.file, ignored))
        return fail(BadInput, options.file
                                  + " exists already; with --replace the new study takes "
                                    "its place.");
    const std::string text = studyText(study);
    if (const auto again = studyOf(text); !again) // what cannot be read is not written
        return fail(WrongUsage, "The study " + again.message().english() + ".");
    const auto scene = readScene(options.scene);
    if (!scene)
        return fail(BadInput, scene.message());
    for (const StudyVariable& variable : study.variables)
        for (const std::string& path : variable.paths)
            if (const auto failure = checkValues(*scene, path, variable.values))
                return fail(WrongUsage, Message("--vary %1", failure->message));
    if (const auto opened = openStudy(study, options.file); !opened) // what cannot be flown is not
        return fail(WrongUsage, opened.message());                   // written either
    if (const auto failure = replaceFile(options.file, text))
        return fail(BadInput, failure->message);
    return Done;
}

void addGoals(CLI::App& command, NewOptions& options)
{
    const auto add = [&](const char* name, std::vector<std::string>& texts, const char* help,
                         const char* type) {
        command.add_option(name, texts, help)->type_name(type)->allow_extra_args(false);
    };
    constexpr const char* measure = "MEASURE";
    constexpr const char* bound = "MEASURE=NUMBER";
    add("--maximise", options.maximise,
        "What is wanted large: a probe and its reduction, as \"line angle mean from 2\"", measure);
    add("--minimise", options.minimise, "What is wanted small", measure);
    add("--target", options.target, "What is wanted at a value", bound);
    add("--at-most", options.atMost, "What must not be larger", bound);
    add("--at-least", options.atLeast, "What must not be smaller", bound);
    command.add_flag("--no-tear", options.noTear, "Nothing may tear");
    command.add_flag("--accurate", options.accurate, "The wanted accuracy has to be held");
    const CLI::Range some(std::int64_t(1), std::int64_t(10000));
    command
        .add_option("--population", options.population, "Points of a generation of an optimiser")
        ->check(some);
    command.add_option("--generations", options.generations, "Generations of an optimiser")
        ->check(some);
    command.add_option("--polish", options.polish, "Flights of an optimiser's last stage")
        ->check(CLI::Range(std::int64_t(0), std::int64_t(10000)));
}

} // namespace

void addStudyNew(CLI::App& study, Command& chosen)
{
    CLI::App* command = study.add_subcommand("new", "Write the file of a study.");
    const auto options = std::make_shared<NewOptions>();
    addGoals(*command, *options);
    command->add_option("STUDY", options->file, "The file, *.ripstop-study.json")->required();
    command->add_option("--scene", options->scene, "The scene that is flown")->required();
    command
        ->add_option("--vary", options->vary,
                     "A property and its values, as of sweep, or a range LOW..HIGH or \"LOW..HIGH "
                     "log\"; PATH+PATH=VALUES gives several the same value")
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
        ->transform(secondsBetween(0.0, 1e9))
        ->type_name("T");
    command->add_flag("--until-tear", options->untilTear, "End a flight with its first tear");
    command->add_flag("--replace", options->replaces, "Also where there is a file of that name");
    command->callback([options, &chosen] { chosen = [options] { return newStudy(*options); }; });
}

} // namespace ripstop
