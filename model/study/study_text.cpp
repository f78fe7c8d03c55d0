// studyText() writes what studyOf() reads.
#include "study/study.h"

#include "study/study_fields.h"

#include <cmath>

namespace ripstop {
namespace {

using Json = StudyJson;

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
    const bool isRange =
        variable.spread
        && (!variable.values.empty() || variable.spread->kind == Distribution::Kind::Log);
    if (isRange) {
        json["from"] = variable.spread->a;
        json["to"] = variable.spread->b;
        if (!variable.values.empty())
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

Json planJson(const StudyPlan& plan)
{
    Json json{{"kind", choiceNames<StudyPlan::Kind>[std::size_t(plan.kind)]}};
    if (plan.kind == StudyPlan::Kind::Optimise) {
        json["method"] = choiceNames<StudyPlan::Method>[std::size_t(plan.method)];
        json["population"] = plan.population;
        json["generations"] = plan.generations;
        if (plan.polish > 0)
            json["polish"] = plan.polish;
        json["seed"] = plan.seed;
    } else if (plan.count > 0) {
        json["count"] = plan.count;
        json["seed"] = plan.seed;
    }
    if (!plan.file.empty())
        json["file"] = plan.file;
    return json;
}

Json measureJson(const Measure& measure)
{
    Json json{{"probe", measure.probe},
              {"reduction", choiceNames<Reduction>[std::size_t(measure.reduction)]}};
    if (measure.reduction == Reduction::Percentile)
        json["percent"] = measure.percent;
    if (measure.from > 0.0)
        json["from"] = measure.from;
    if (std::isfinite(measure.to))
        json["to"] = measure.to;
    return json;
}

Json objectiveJson(const Objective& objective)
{
    Json json = measureJson(objective.measure);
    json["goal"] = choiceNames<Goal>[std::size_t(objective.goal)];
    if (objective.goal == Goal::Target)
        json["target"] = objective.target;
    return json;
}

Json constraintJson(const Constraint& constraint)
{
    if (constraint.kind == Constraint::Kind::Outcome)
        return {{"outcome", choiceNames<WantedOutcome>[std::size_t(constraint.outcome)]}};
    Json json = measureJson(constraint.measure);
    json[constraint.kind == Constraint::Kind::AtMost ? "atMost" : "atLeast"] = constraint.limit;
    return json;
}

} // namespace

std::string studyText(const Study& study)
{
    Json json{{"format", studyFormat}, {"version", studyVersion}};
    if (!study.title.empty())
        json["title"] = study.title;
    json["scene"] = study.scene;
    if (!study.controls.empty())
        json["controls"] = study.controls;
    json["seconds"] = study.seconds;
    if (study.untilTear)
        json["untilTear"] = true;
    if (study.keep != KeptRuns::Nothing)
        json["keep"] = choiceNames<KeptRuns>[std::size_t(study.keep)];
    if (study.keep == KeptRuns::Best)
        json["keepCount"] = study.keepCount;
    for (const StudyVariable& variable : study.variables)
        json["variables"].push_back(variableJson(variable));
    json["plan"] = planJson(study.plan);
    for (const Measure& measure : study.measures)
        json["measures"].push_back(measureJson(measure));
    for (const Objective& objective : study.objectives)
        json["objectives"].push_back(objectiveJson(objective));
    for (const Constraint& constraint : study.constraints)
        json["constraints"].push_back(constraintJson(constraint));
    return json.dump(2) + '\n';
}

} // namespace ripstop
