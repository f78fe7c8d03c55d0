// A study: one design flown many times with other values, and what is read of each flight.
//
// A study is a file, NAME.ripstop-study.json. It names a scene, the variables with the values that
// they take, the plan that makes points of them (plan.h), how long each point is flown, and what is
// measured (measure.h). What has been flown is kept beside it (ledger.h). Nothing in a study is
// computed: it is what its author wrote.
#pragma once

#include "base/choice_names.h"
#include "base/result.h"
#include "study/distribution.h"
#include "study/goal.h"
#include "study/measure.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// Several properties that get the same value are tied together: the stiffness of two sails.
struct StudyVariable
{
    std::string name;                   // of its column, and in a file of points
    std::vector<std::string> paths;     // of properties (scene/path.h), at least one
    std::vector<std::string> values;    // that grids go through, as --set takes them
    std::optional<Distribution> spread; // that other plans draw from; they draw from `values`
                                        // without one, each alike
};

// Values from one end to the other, evenly or by even factors, and what other plans draw from
// between them. `from` is below `to`, and above 0 where it is logarithmic.
StudyVariable rangeVariable(double from, double to, int count, bool isLogarithmic);

struct StudyPlan
{
    enum class Kind {
        Grid,           // all combinations of the values
        OneAtATime,     // the first value of each, then the others of each alone
        LatinHypercube, // `count` points, each variable spread evenly (McKay and others 1979)
        Sobol,          // the first `count` points of Sobol' (1967), shifted by the seed
        MonteCarlo,     // `count` points at random
        Points,         // the rows of a file of somebody else's
        Frontier,       // those of a grid that tell where outcomes change (frontier_search.h)
        Optimise,       // those that lead to the best (optimiser.h)
        Sensitivity     // `count` blocks of points that tell which variable matters (sensitivity.h)
    };
    enum class Method { ParticleSwarm, Nsga2 };

    Kind kind = Kind::Grid;
    std::int64_t count = 0;
    std::uint64_t seed = 1;
    std::string file;                      // CSV with a column for each variable, beside the study
    Method method = Method::ParticleSwarm; // of an optimisation, as what follows
    std::int64_t population = 16;          // points of a generation, which are flown at once
    std::int64_t generations = 20;
    std::int64_t polish = 0; // flights of the last stage, one after the other

    bool draws() const // `count` points from distributions
    {
        return kind == Kind::LatinHypercube || kind == Kind::Sobol || kind == Kind::MonteCarlo
               || kind == Kind::Sensitivity;
    }
    bool isSearch() const { return kind == Kind::Frontier || kind == Kind::Optimise; }
    bool isGrid() const { return kind == Kind::Grid || kind == Kind::Frontier; }
    bool goesThroughValues() const { return isGrid() || kind == Kind::OneAtATime; }
};

template <>
inline constexpr std::array choiceNames<StudyPlan::Kind>{
    "grid",   "one_at_a_time", "latin_hypercube", "sobol",      "monte_carlo",
    "points", "frontier",      "optimise",        "sensitivity"};

template <>
inline constexpr std::array choiceNames<StudyPlan::Method>{"particle_swarm", "nsga2"};

// Which flights are kept with all of their frames, beside the rows.
enum class KeptRuns {
    Nothing,
    Failed, // that tore or ended early
    Best,   // `keepCount` of those that are best so far (kept_runs.h)
    All
};

template <>
inline constexpr std::array choiceNames<KeptRuns>{"nothing", "failed", "best", "all"};

struct Study
{
    std::string title;
    std::string scene;    // file, beside the study
    std::string controls; // control track (io/control_track.h), or empty
    std::vector<StudyVariable> variables;
    StudyPlan plan;
    double seconds = 10.0;         // s, of each flight
    bool untilTear = false;        // a flight ends with its first tear
    std::vector<Measure> measures; // empty: last, mean, least and largest value of each probe
    std::vector<Objective> objectives;
    std::vector<Constraint> constraints;
    KeptRuns keep = KeptRuns::Nothing;
    int keepCount = 5;            // of the best, 1 to mostKept
    std::filesystem::path folder; // where the files are that it names
};

inline constexpr std::string_view studyEnding = ".ripstop-study.json";
inline constexpr double mostStudyPoints = 1e8;
inline constexpr int mostKept = 1000; // of the best

// Failures name the file and the field.
Result<Study> readStudy(const std::filesystem::path& file);
Result<Study> studyOf(const std::string& text); // a failure is half a sentence

std::string studyText(const Study& study);

} // namespace ripstop
