// readStudy() puts the name of the file before what studyOf() says. studyOf() reads the fields one
// after the other through Fields, which knows where it is ("variables[2].from") and refuses what
// nobody reads, so that a misspelt field is no silent default. studyText() writes what studyOf()
// reads. nlohmann's exceptions never begin: everything is asked for before it is taken.
#include "study/study.h"

#include "io/json_text.h"
#include "io/whole_file.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <set>

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* formatName = "ripstop-study";
constexpr int formatVersion = 1;
constexpr int mostOfRange = 100'000;

// 10000 for the middle of a range from 1000 to 100000 that is logarithmic.
std::string rounded(double number)
{
    char text[32]; // and a point in every language
    return {text,
            std::to_chars(text, text + sizeof text, number, std::chars_format::general, 12).ptr};
}

// The fields of an object, and the first thing that is wrong with them.
class Fields
{
public:
    Fields(const Json& object, std::string place, std::optional<Failure>& failure)
        : m_object(object)
        , m_place(std::move(place))
        , m_failure(failure)
    {
        if (!object.is_object())
            say(Message("has %1, which is no object in braces", where({})));
    }

    bool has(const char* key) const { return m_object.is_object() && m_object.contains(key); }

    std::string text(const char* key, bool isNeeded = false)
    {
        const Json* field = find(key, isNeeded);
        if (field && !field->is_string())
            say(Message("has %1, which is no text in quotation marks", where(key)));
        return field && field->is_string() ? field->get<std::string>() : std::string();
    }

    double number(const char* key, double usual, double least, double most)
    {
        const Json* field = find(key, std::isnan(usual));
        if (!field)
            return usual;
        const double value = field->is_number() ? field->get<double>() : std::nan("");
        if (!(value >= least && value <= most)) {
            say(Message("has %1, which is no number from %2 to %3", where(key),
                        Message::number("%.6g", least), Message::number("%.6g", most)));
            return usual;
        }
        return value;
    }

    bool flag(const char* key)
    {
        const Json* field = find(key, false);
        if (field && !field->is_boolean())
            say(Message("has %1, which is neither true nor false", where(key)));
        return field && field->is_boolean() && field->get<bool>();
    }

    template <typename Choice>
    Choice choice(const char* key, Choice usual)
    {
        const std::string name = text(key);
        if (name.empty())
            return usual;
        std::string all;
        for (std::size_t i = 0; i < choiceNames<Choice>.size(); ++i) {
            if (name == choiceNames<Choice>[i])
                return Choice(i);
            all += (i ? ", " : "") + std::string(choiceNames<Choice>[i]);
        }
        say(Message("has %1 = \"%2\"; it is one of %3", where(key), name, all));
        return usual;
    }

    // Calls visit(element, place) for each of an array; nothing where there is none.
    template <typename Visit>
    void each(const char* key, bool isNeeded, Visit visit)
    {
        const Json* field = find(key, isNeeded);
        if (field && !field->is_array()) {
            say(Message("has %1, which is no list in brackets", where(key)));
            return;
        }
        for (std::size_t i = 0; field && i < field->size(); ++i)
            visit((*field)[i], where(key) + '[' + std::to_string(i) + ']');
    }

    // After all that is read has been read. It is said before that a field is missing, which it may
    // have been meant to be.
    void refuseOthers()
    {
        if (m_object.is_object())
            for (const auto& field : m_object.items())
                if (!m_read.contains(field.key()))
                    m_failure =
                        Failure("has %1, which means nothing to this version", where(field.key()));
    }

    std::string where(const std::string& key) const
    {
        return m_place.empty() ? key : key.empty() ? m_place : m_place + '.' + key;
    }

    void say(Message message)
    {
        if (!m_failure)
            m_failure = Failure(std::move(message));
    }

    // The field, or null; says so where it is needed.
    const Json* find(const char* key, bool isNeeded)
    {
        m_read.insert(key);
        if (has(key))
            return &m_object[key];
        if (isNeeded)
            say(Message("has no %1", where(key)));
        return nullptr;
    }

private:
    const Json& m_object;
    std::string m_place;
    std::optional<Failure>& m_failure;
    std::set<std::string> m_read;
};

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
    const int count = int(fields.number("count", 0.0, 2.0, mostOfRange));
    const std::string scale = fields.text("scale");
    const bool isLog = scale == "log";
    if (!scale.empty() && !isLog && scale != "linear")
        fields.say(Message("has %1 = \"%2\"; it is one of %3", fields.where("scale"), scale,
                           "linear, log"));
    if (!(from < to) || (isLog && !(from > 0.0))) {
        fields.say(Message("has %1, which does not lead upwards, or not from above 0 where its "
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
        fields.say(Message("has %1 = \"%2\"; it is one of %3", fields.where("distribution"), name,
                           "uniform, normal, log_normal, triangular"));
    const bool hasEnds = spread.kind == Kind::Uniform || spread.kind == Kind::Triangular;
    const bool isInside =
        spread.kind != Kind::Triangular || (spread.c >= spread.a && spread.c <= spread.b);
    if (hasEnds && !(spread.a < spread.b && isInside))
        fields.say(
            Message("has %1, whose low, mode and high do not rise", fields.where("distribution")));
    variable.spread = spread;
}

StudyVariable readVariable(const Json& json, const std::string& place,
                           std::optional<Failure>& failure)
{
    Fields fields(json, place, failure);
    StudyVariable variable;
    variable.name = fields.text("name");
    fields.each("paths", true, [&](const Json& path, const std::string& where) {
        if (path.is_string())
            variable.paths.push_back(path.get<std::string>());
        else
            fields.say(Message("has %1, which is no text in quotation marks", where));
    });
    if (variable.paths.empty())
        fields.say(Message("has no %1", fields.where("paths")));
    if (variable.name.empty() && !variable.paths.empty())
        variable.name = variable.paths.front();
    if (fields.has("values"))
        fields.each("values", true, [&](const Json& value, const std::string& where) {
            if (value.is_object() || value.is_array() || value.is_null())
                fields.say(Message("has %1, which is neither a number nor a text", where));
            variable.values.push_back(valueText(value));
        });
    else if (fields.has("from"))
        readRange(fields, variable);
    else
        readDistribution(fields, variable);
    fields.refuseOthers();
    return variable;
}

StudyPlan readPlan(const Json& json, std::optional<Failure>& failure)
{
    Fields fields(json, "plan", failure);
    StudyPlan plan;
    plan.kind = fields.choice("kind", StudyPlan::Kind::Grid);
    using Kind = StudyPlan::Kind;
    const bool draws = plan.kind == Kind::LatinHypercube || plan.kind == Kind::Sobol
                       || plan.kind == Kind::MonteCarlo;
    if (draws) {
        plan.count = std::int64_t(fields.number("count", std::nan(""), 1.0, mostStudyPoints));
        plan.seed = std::uint64_t(fields.number("seed", 1.0, 0.0, 9007199254740992.0));
    }
    if (plan.kind == Kind::Points)
        plan.file = fields.text("file", true);
    fields.refuseOthers();
    return plan;
}

Measure readMeasure(const Json& json, const std::string& place, std::optional<Failure>& failure)
{
    Fields fields(json, place, failure);
    Measure measure;
    measure.probe = fields.text("probe", true);
    measure.reduction = fields.choice("reduction", Reduction::Last);
    if (measure.reduction == Reduction::Percentile)
        measure.percent = fields.number("percent", measure.percent, 0.0, 100.0);
    measure.from = fields.number("from", 0.0, 0.0, 1e9);
    measure.to = fields.number("to", measure.to, 0.0, measure.to);
    fields.refuseOthers();
    return measure;
}

// A grid needs values, and what draws needs something to draw from.
void checkVariables(const Study& study, std::optional<Failure>& failure)
{
    std::set<std::string> names;
    for (const StudyVariable& variable : study.variables) {
        if (failure)
            return;
        if (!names.insert(variable.name).second)
            failure = Failure("has two variables that are called %1", variable.name);
        else if (study.plan.goesThroughValues() && variable.values.empty())
            failure = Failure("has a plan that goes through values, and the variable %1 has none; "
                              "give it \"values\", or \"from\", \"to\" and \"count\"",
                              variable.name);
    }
}

Json distributionJson(const Distribution& spread)
{
    switch (spread.kind) {
    case Distribution::Kind::Normal:
        return {{"distribution", "normal"}, {"mean", spread.a}, {"deviation", spread.b}};
    case Distribution::Kind::LogNormal:
        return {{"distribution", "log_normal"}, {"median", spread.a}, {"deviation", spread.b}};
    case Distribution::Kind::Triangular:
        return {{"distribution", "triangular"},
                {"low", spread.a},
                {"high", spread.b},
                {"mode", spread.c}};
    case Distribution::Kind::Uniform:
    case Distribution::Kind::Log: // of ranges alone, which variableJson() writes
        break;
    }
    return {{"distribution", "uniform"}, {"low", spread.a}, {"high", spread.b}};
}

Json variableJson(const StudyVariable& variable)
{
    Json json{{"name", variable.name}, {"paths", variable.paths}};
    const bool isRange = variable.spread && !variable.values.empty();
    if (isRange) {
        json["from"] = variable.spread->a;
        json["to"] = variable.spread->b;
        json["count"] = variable.values.size();
        if (variable.spread->kind == Distribution::Kind::Log)
            json["scale"] = "log";
    } else if (variable.spread) {
        json.update(distributionJson(*variable.spread));
    } else {
        json["values"] = variable.values;
    }
    return json;
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
    const Json json = Json::parse(text, nullptr, false);
    const auto says = [&](const char* key, const Json& value) {
        return json.contains(key) && json[key] == value;
    };
    if (!json.is_object() || !says("format", formatName))
        return Failure("is no study");
    if (!says("version", formatVersion))
        return Failure("was written by another version of Ripstop; use that");
    std::optional<Failure> failure;
    Fields fields(json, {}, failure);
    Study study;
    fields.text("format");
    fields.number("version", formatVersion, formatVersion, formatVersion);
    study.title = fields.text("title");
    study.scene = fields.text("scene", true);
    study.controls = fields.text("controls");
    study.seconds = fields.number("seconds", std::nan(""), 0.0, 1e9);
    study.untilTear = fields.flag("untilTear");
    fields.each("variables", true, [&](const Json& variable, const std::string& place) {
        study.variables.push_back(readVariable(variable, place, failure));
    });
    if (const Json* plan = fields.find("plan", false))
        study.plan = readPlan(*plan, failure);
    fields.each("measures", false, [&](const Json& measure, const std::string& place) {
        study.measures.push_back(readMeasure(measure, place, failure));
    });
    fields.refuseOthers();
    checkVariables(study, failure);
    if (failure)
        return *failure;
    return study;
}

Result<Study> readStudy(const std::filesystem::path& file)
{
    const auto content =
        readWholeFile(file, [](std::string_view) { return std::optional<Message>(); });
    if (!content)
        return content.failure();
    auto study = studyOf(*content);
    if (!study)
        return Failure("%1 %2.", file.string(), study.message());
    study->folder = file.parent_path();
    return study;
}

std::string studyText(const Study& study)
{
    Json json{{"format", formatName}, {"version", formatVersion}};
    if (!study.title.empty())
        json["title"] = study.title;
    json["scene"] = study.scene;
    if (!study.controls.empty())
        json["controls"] = study.controls;
    json["seconds"] = study.seconds;
    if (study.untilTear)
        json["untilTear"] = true;
    for (const StudyVariable& variable : study.variables)
        json["variables"].push_back(variableJson(variable));
    Json plan{{"kind", choiceNames<StudyPlan::Kind>[std::size_t(study.plan.kind)]}};
    if (study.plan.count > 0) {
        plan["count"] = study.plan.count;
        plan["seed"] = study.plan.seed;
    }
    if (!study.plan.file.empty())
        plan["file"] = study.plan.file;
    json["plan"] = plan;
    for (const Measure& measure : study.measures) {
        Json one{{"probe", measure.probe},
                 {"reduction", choiceNames<Reduction>[std::size_t(measure.reduction)]}};
        if (measure.reduction == Reduction::Percentile)
            one["percent"] = measure.percent;
        if (measure.from > 0.0)
            one["from"] = measure.from;
        if (std::isfinite(measure.to))
            one["to"] = measure.to;
        json["measures"].push_back(one);
    }
    return json.dump(2) + '\n';
}

} // namespace ripstop
