// openStudy() reads study, scene, points and controls in this order, then looks at what the study
// measures and at what it sets before it makes the keys of its flights.
#include "study/opened_study.h"

#include "io/scene_file.h"
#include "study/point_scene.h"
#include "study/study_search.h"

#include <algorithm>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

// The place of a measure in the plan, which gets it where it does not have it.
std::size_t placeOf(FlightPlan& plan, const Measure& measure)
{
    const auto found = std::ranges::find(plan.measures, measure);
    const auto place = std::size_t(found - plan.measures.begin());
    if (found == plan.measures.end())
        plan.measures.push_back(measure);
    return place;
}

// Names of the measures with their units; the usual measures where the study names none, and those
// of its objectives and constraints.
std::optional<Failure> nameMeasures(OpenedStudy& opened)
{
    const auto probes = probesOf(opened.scene);
    if (!probes)
        return Failure("%1: %2", opened.sceneFile.string(), probes.message());
    if (opened.plan.measures.empty())
        opened.plan.measures = usualMeasures(*probes);
    for (const Objective& objective : opened.study.objectives)
        opened.wanted.push_back(placeOf(opened.plan, objective.measure));
    for (const Constraint& constraint : opened.study.constraints)
        opened.constrained.push_back(constraint.kind == Constraint::Kind::Outcome
                                         ? 0
                                         : placeOf(opened.plan, constraint.measure));
    for (const Measure& measure : opened.plan.measures) {
        const auto probe = std::ranges::find(*probes, measure.probe, &Layout::Probe::name);
        if (probe == probes->end()) {
            std::string all;
            for (const Layout::Probe& one : *probes)
                all += (all.empty() ? "" : ", ") + one.name;
            return Failure("%1 measures the probe %2, and the scene has: %3.", opened.file.string(),
                           measure.probe, all.empty() ? "none" : all);
        }
        opened.headings.push_back(headingOf(measure, probe->unit));
    }
    return std::nullopt;
}

// The files of variables that set controls.
std::optional<Failure> readTracks(OpenedStudy& opened)
{
    for (std::size_t v = 0; v < opened.study.variables.size(); ++v) {
        const StudyVariable& variable = opened.study.variables[v];
        if (std::ranges::find(variable.paths, controlsPath) == variable.paths.end())
            continue;
        if (variable.spread)
            return Failure(
                "%1: the variable %2 sets controls, which are files; give it \"values\".",
                opened.file.string(), variable.name);
        std::vector<std::string> names = variable.values;
        if (opened.study.plan.kind == StudyPlan::Kind::Points)
            for (std::size_t i = 0; i < opened.points.count(); ++i)
                names.push_back(opened.points.values(i)[v]);
        for (const std::string& name : names) {
            if (opened.tracks.contains(name))
                continue;
            const fs::path place = opened.study.folder / name;
            auto track = readControlTrack(place, opened.scene);
            if (!track)
                return track.failure();
            const auto hash = hashOfFile(place);
            if (!hash)
                return hash.failure();
            opened.tracks.emplace(name, StudyTrack{std::move(*track), *hash});
        }
    }
    return std::nullopt;
}

// Whether what the plan sets can be set: each value of each variable, or those of the first point
// where values are drawn.
std::optional<Failure> checkAssignments(const OpenedStudy& opened)
{
    std::vector<std::string> all;
    for (const StudyVariable& variable : opened.study.variables)
        for (const std::string& path : variable.paths)
            for (const std::string& value : variable.values)
                all.push_back(path + '=' + value);
    if (opened.points.count() > 0)
        for (std::string& one : opened.assignments(0))
            all.push_back(std::move(one));
    for (const std::string& one : all)
        if (const auto failure = checkAssignment(opened.scene, one))
            return Failure("%1: %2: %3", opened.file.string(), one, failure->message);
    return std::nullopt;
}

} // namespace

std::string OpenedStudy::key(std::size_t point) const
{
    std::vector<std::string> all = assignments(point);
    for (std::string& one : all)
        if (setsControls(one)) // what counts is what stands in the file
            one = std::string(controlsPath) + '=' + tracks.at(one.substr(one.find('=') + 1)).hash;
    return keys.of(all);
}

const ControlTrack& OpenedStudy::controlsOf(std::size_t point) const
{
    if (!tracks.empty())
        for (const std::string& one : assignments(point))
            if (setsControls(one))
                return tracks.at(one.substr(one.find('=') + 1)).controls;
    return controls;
}

Result<OpenedStudy> openStudy(const fs::path& file, const std::optional<fs::path>& design)
{
    auto study = readStudy(file);
    if (!study)
        return study.failure();
    return openStudy(std::move(*study), file, design);
}

Result<OpenedStudy> openStudy(Study study, const fs::path& file,
                              const std::optional<fs::path>& design)
{
    const fs::path sceneFile = study.folder / study.scene;
    auto scene = readScene(design ? *design : sceneFile);
    if (!scene)
        return scene.failure();
    scene->folder.path = sceneFile.parent_path(); // where the files are that it names
    auto points = StudyPoints::of(study);
    if (!points)
        return Failure("%1: %2", file.string(), points.message());
    OpenedStudy opened{std::move(study),
                       std::move(*scene),
                       {},
                       std::move(*points),
                       {},
                       {},
                       {},
                       file,
                       sceneFile,
                       {},
                       {},
                       {},
                       {},
                       {}};
    beginSearch(opened);
    if (!opened.study.controls.empty()) {
        opened.controlsFile = opened.study.folder / opened.study.controls;
        auto track = readControlTrack(opened.controlsFile, opened.scene);
        if (!track)
            return track.failure();
        opened.controls = std::move(*track);
    }
    if (auto failure = readTracks(opened))
        return *failure;
    opened.plan.seconds = opened.study.seconds;
    opened.plan.untilTear = opened.study.untilTear;
    opened.plan.measures = opened.study.measures;
    if (auto failure = nameMeasures(opened))
        return *failure;
    if (auto failure = checkAssignments(opened))
        return *failure;
    auto keys = FlightKeys::of(opened.scene, opened.controlsFile, opened.plan);
    if (!keys)
        return keys.failure();
    opened.keys = std::move(*keys);
    return opened;
}

Result<Scene> sceneOf(const OpenedStudy& opened, std::size_t point)
{
    return sceneWith(opened.scene, opened.assignments(point));
}

} // namespace ripstop
