// studyIn() reads the fields one after the other (study_fields.h); readStudy() puts the name of the
// file before what is wrong, and the line and column of the field.
#include "study/study.h"

#include "io/json_place.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "study/polish.h"
#include "study/study_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <set>

namespace ripstop {
namespace {

using Json = StudyJson;
using Fields = StudyFields;

constexpr int mostOfRange = 100'000;

// 10000 for the middle of a range from 1000 to 100000 that is logarithmic.
std::string rounded(double number)
{
    char text[32]; // and a point in every language
    return {text,
            std::to_chars(text, text + sizeof text, number, std::chars_format::general, 12).ptr};
}

// What --set takes: a text, or a number as it is.
std::string valueText(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_number_float())
        return numberText(value.get<double>());
    return value.dump(); // 5, true
}

// "from" and "to" with "count" are values for a grid, and what other plans draw from between them.
void readRange(Fields& fields, StudyVariable& variable)
{
    const double from = fields.number("from", std::nan(""), -1e300, 1e300);
    const double to = fields.number("to", std::nan(""), -1e300, 1e300);
    const int count = int(fields.number("count", 0.0, 2.0, mostOfRange)); // without it, no values
    const std::string scale = fields.text("scale");
    const bool isLog = scale == "log";
    if (!scale.empty() && !isLog && scale != "linear")
        fields.say("scale", Message("has %1 = \"%2\"; it is one of %3", fields.where("scale"),
                                    scale, "linear, log"));
    if (!(from < to) || (isLog && !(from > 0.0))) {
        fields.say("from",
                   Message("has %1, which does not lead upwards, or not from above 0 where its "
                           "scale is log",
                           fields.where("from")));
        return;
    }
    const StudyVariable range = rangeVariable(from, to, count, isLog);
    variable.spread = range.spread;
    variable.values = range.values;
}

void readDistribution(Fields& fields, StudyVariable& variable)
{
    const std::string name = fields.text("distribution", true);
    const auto number = [&](const char* key, double least = -1e300) {
        return fields.number(key, std::nan(""), least, 1e300);
    };
    using Kind = Distribution::Kind;
    Distribution spread;
    if (name == "uniform")
        spread = {Kind::Uniform, number("low"), number("high")};
    else if (name == "normal")
        spread = {Kind::Normal, number("mean"), number("deviation", 0.0)};
    else if (name == "log_normal")
        spread = {Kind::LogNormal, number("median", 1e-300), number("deviation", 0.0)};
    else if (name == "triangular")
        spread = {Kind::Triangular, number("low"), number("high"), number("mode")};
    else
        fields.say("distribution",
                   Message("has %1 = \"%2\"; it is one of %3", fields.where("distribution"), name,
                           "uniform, normal, log_normal, triangular"));
    const bool hasEnds = spread.kind == Kind::Uniform || spread.kind == Kind::Triangular;
    const bool isInside =
        spread.kind != Kind::Triangular || (spread.c >= spread.a && spread.c <= spread.b);
    if (hasEnds && !(spread.a < spread.b && isInside))
        fields.say("distribution", Message("has %1, whose low, mode and high do not rise",
                                           fields.where("distribution")));
    variable.spread = spread;
}

StudyVariable readVariable(const Json& json, const std::string& place,
                           std::optional<StudyFault>& fault)
{
    Fields fields(json, place, fault);
    StudyVariable variable;
    variable.name = fields.text("name");
    fields.each("paths", true, [&](const Json& path, const std::string& where) {
        if (path.is_string())
            variable.paths.push_back(path.get<std::string>());
        else
            fields.sayAt(where, Message("has %1, which is no text in quotation marks", where));
    });
    if (variable.paths.empty())
        fields.say("", Message("has no %1", fields.where("paths")));
    if (variable.name.empty() && !variable.paths.empty())
        variable.name = variable.paths.front();
    if (fields.has("values"))
        fields.each("values", true, [&](const Json& value, const std::string& where) {
            if (value.is_object() || value.is_array() || value.is_null())
                fields.sayAt(where, Message("has %1, which is neither a number nor a text", where));
            variable.values.push_back(valueText(value));
        });
    else if (fields.has("from"))
        readRange(fields, variable);
    else
        readDistribution(fields, variable);
    fields.refuseOthers();
    return variable;
}

StudyPlan readPlan(const Json& json, std::optional<StudyFault>& fault)
{
    Fields fields(json, "plan", fault);
    StudyPlan plan;
    plan.kind = fields.choice("kind", StudyPlan::Kind::Grid);
    using Kind = StudyPlan::Kind;
    const auto whole = [&](const char* key, double usual, double least, double most) {
        return std::int64_t(fields.number(key, usual, least, most));
    };
    if (plan.draws())
        plan.count = whole("count", std::nan(""), 1.0, mostStudyPoints);
    if (plan.draws() || plan.kind == Kind::Optimise)
        plan.seed = std::uint64_t(fields.number("seed", 1.0, 0.0, 9007199254740992.0));
    if (plan.kind == Kind::Optimise) {
        plan.method = fields.choice("method", plan.method);
        plan.population = whole("population", double(plan.population), 2.0, 1e4);
        plan.generations = whole("generations", double(plan.generations), 1.0, 1e4);
        plan.polish = whole("polish", 0.0, 0.0, 1e4);
        if (plan.polish > 0 && !Polish::isThere())
            fields.say("polish",
                       Message("has %1, and this Ripstop was built without NLopt, which polishes; "
                               "leave it out",
                               fields.where("polish")));
    }
    if (plan.kind == Kind::Points)
        plan.file = fields.text("file", true);
    fields.refuseOthers();
    return plan;
}

// "probe", "reduction" and what belongs to them.
Measure measureIn(Fields& fields)
{
    Measure measure;
    measure.probe = fields.text("probe", true);
    measure.reduction = fields.choice("reduction", Reduction::Last);
    if (measure.reduction == Reduction::Percentile)
        measure.percent = fields.number("percent", measure.percent, 0.0, 100.0);
    measure.from = fields.number("from", 0.0, 0.0, 1e9);
    measure.to = fields.number("to", measure.to, 0.0, measure.to);
    return measure;
}

Measure readMeasure(const Json& json, const std::string& place, std::optional<StudyFault>& fault)
{
    Fields fields(json, place, fault);
    const Measure measure = measureIn(fields);
    fields.refuseOthers();
    return measure;
}

Objective readObjective(const Json& json, const std::string& place,
                        std::optional<StudyFault>& fault)
{
    Fields fields(json, place, fault);
    Objective objective;
    objective.measure = measureIn(fields);
    objective.goal = fields.choice("goal", Goal::Minimise);
    if (objective.goal == Goal::Target)
        objective.target = fields.number("target", std::nan(""), -1e300, 1e300);
    fields.refuseOthers();
    return objective;
}

// A measure with "atMost" or "atLeast", or an "outcome".
Constraint readConstraint(const Json& json, const std::string& place,
                          std::optional<StudyFault>& fault)
{
    Fields fields(json, place, fault);
    Constraint constraint;
    if (fields.has("outcome")) {
        constraint.outcome = fields.choice("outcome", WantedOutcome::NoTear);
    } else {
        const bool isMost = fields.has("atMost");
        constraint.kind = isMost ? Constraint::Kind::AtMost : Constraint::Kind::AtLeast;
        constraint.measure = measureIn(fields);
        constraint.limit =
            fields.number(isMost ? "atMost" : "atLeast", std::nan(""), -1e300, 1e300);
    }
    fields.refuseOthers();
    return constraint;
}

// What is best needs something that is wanted, and an optimisation a method that can.
void checkGoals(const Study& study, std::optional<StudyFault>& fault)
{
    if (!fault && study.keep == KeptRuns::Best && study.objectives.empty())
        fault = {"keep",
                 Message("keeps the best flights, and has no objectives; say what is wanted")};
    if (fault || study.plan.kind != StudyPlan::Kind::Optimise)
        return;
    const bool isSwarm = study.plan.method == StudyPlan::Method::ParticleSwarm;
    if (study.objectives.empty())
        fault = {"plan",
                 Message("has a plan that optimises, and no objectives; say what is wanted")};
    else if (study.objectives.size() > 1 && (isSwarm || study.plan.polish > 0))
        fault = {"plan",
                 Message("has several objectives, which the method nsga2 is for, without polish")};
}

// A grid needs values, and what draws needs something to draw from.
void checkVariables(const Study& study, std::optional<StudyFault>& fault)
{
    std::set<std::string> names, paths;
    for (std::size_t v = 0; v < study.variables.size() && !fault; ++v) {
        const StudyVariable& variable = study.variables[v];
        const std::string place = "variables[" + std::to_string(v) + ']';
        if (!names.insert(variable.name).second)
            fault = {place, Message("has two variables that are called %1", variable.name)};
        else if (const auto again = std::ranges::find_if(
                     variable.paths, [&](const auto& path) { return !paths.insert(path).second; });
                 again != variable.paths.end())
            fault = {place,
                     Message("sets %1 a second time, and one value alone can be flown; leave "
                             "it out of all but one variable",
                             *again)};
        else if (study.plan.goesThroughValues() && variable.values.empty())
            fault = {place, Message("has a plan that goes through values, and the variable %1 has "
                                    "none; give it \"values\", or \"from\", \"to\" and "
                                    "\"count\"",
                                    variable.name)};
    }
}

// Where a text is broken, as the reader of scenes tells it.
std::optional<Failure> brokenPlace(const std::string& text)
{
    std::optional<Failure> failure;
    walkJson(text, 0, true, [&](const JsonEvent& event) {
        if (event.type != JsonEvent::Type::Error)
            return true;
        const TextPlace place = textPlace(text, event.end > 0 ? event.end - 1 : 0);
        failure = Failure("is no study: line %1, column %2 %3", place.line, place.column,
                          std::string(event.text));
        return false;
    });
    return failure;
}

// Reads the fields, and names the place of the first that is wrong.
Study studyIn(const Json& json, std::optional<StudyFault>& fault)
{
    Fields fields(json, {}, fault);
    Study study;
    fields.text("format");
    fields.number("version", studyVersion, studyVersion, studyVersion);
    study.title = fields.text("title");
    study.scene = fields.text("scene", true);
    study.controls = fields.text("controls");
    study.seconds = fields.number("seconds", std::nan(""), 0.0, 1e9);
    study.untilTear = fields.flag("untilTear");
    study.keep = fields.choice("keep", KeptRuns::Nothing);
    if (study.keep == KeptRuns::Best)
        study.keepCount = int(fields.number("keepCount", study.keepCount, 1.0, mostKept));
    fields.each("variables", true, [&](const Json& variable, const std::string& place) {
        study.variables.push_back(readVariable(variable, place, fault));
    });
    if (const Json* plan = fields.find("plan", false))
        study.plan = readPlan(*plan, fault);
    fields.each("measures", false, [&](const Json& measure, const std::string& place) {
        study.measures.push_back(readMeasure(measure, place, fault));
    });
    fields.each("objectives", false, [&](const Json& objective, const std::string& place) {
        study.objectives.push_back(readObjective(objective, place, fault));
    });
    fields.each("constraints", false, [&](const Json& constraint, const std::string& place) {
        study.constraints.push_back(readConstraint(constraint, place, fault));
    });
    fields.refuseOthers();
    checkVariables(study, fault);
    checkGoals(study, fault);
    return study;
}

// What cannot be read as a study at all, then the field that is wrong.
//   says  how the failure of a field is said
Result<Study> readText(const std::string& text,
                       const std::function<Failure(const StudyFault&)>& says)
{
    if (const auto failure = brokenPlace(text))
        return *failure;
    const Json json = Json::parse(text, nullptr, false);
    const auto has = [&](const char* key, const Json& value) {
        return json.contains(key) && json[key] == value;
    };
    if (!json.is_object() || !has("format", studyFormat))
        return Failure("is no study");
    if (!has("version", studyVersion))
        return Failure("was written by another version of Ripstop; use that");
    std::optional<StudyFault> fault;
    Study study = studyIn(json, fault);
    if (fault)
        return says(*fault);
    return study;
}

} // namespace

StudyVariable rangeVariable(double from, double to, int count, bool isLogarithmic)
{
    StudyVariable variable;
    variable.spread = Distribution{
        isLogarithmic ? Distribution::Kind::Log : Distribution::Kind::Uniform, from, to};
    for (int i = 0; i < count; ++i) {
        const double share = double(i) / (count - 1);
        const double value = i == 0           ? from
                             : i == count - 1 ? to
                                              : quantile(*variable.spread, share);
        variable.values.push_back(rounded(value));
    }
    return variable;
}

Result<Study> studyOf(const std::string& text)
{
    return readText(text, [](const StudyFault& fault) { return Failure("%1", fault.message); });
}

Result<Study> readStudy(const std::filesystem::path& file)
{
    const auto content =
        readWholeFile(file, [](std::string_view) { return std::optional<Message>(); });
    if (!content)
        return content.failure();
    auto study = readText(*content, [&](const StudyFault& fault) {
        const TextPlace place = textPlace(*content, beginOfPath(*content, fault.place));
        return Failure("(line %1, column %2) %3", place.line, place.column, fault.message);
    });
    if (!study)
        return Failure("%1 %2.", file.string(), study.message());
    study->folder = file.parent_path();
    return study;
}

} // namespace ripstop
