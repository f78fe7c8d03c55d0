// A study with all that its flights need, made once: what the commands of `study` and the study
// panel of the window share.
#pragma once

#include "base/result.h"
#include "io/control_track.h"
#include "scene/scene.h"
#include "study/flight.h"
#include "study/ledger.h"
#include "study/optimiser.h"
#include "study/plan.h"
#include "study/study.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ripstop {

// A control track that a variable sets, with the hash of its file.
struct StudyTrack
{
    ControlTrack controls;
    std::string hash;
};

struct OpenedStudy
{
    Study study;
    Scene scene;
    ControlTrack controls;
    StudyPoints points;
    FlightPlan plan;
    FlightKeys keys;
    std::vector<std::string> headings; // [measures]
    std::filesystem::path file;
    std::filesystem::path sceneFile;
    std::filesystem::path controlsFile;       // or empty
    std::map<std::string, StudyTrack> tracks; // by the file that a variable names
    std::vector<std::size_t> wanted;          // [objectives] place of its measure in the plan
    std::vector<std::size_t> constrained; // [constraints] the same; 0 of those without a measure
    std::optional<Optimiser> optimiser;   // of a plan that optimises (study_search.h)
    std::size_t told = 0;                 // points whose scores it knows

    std::vector<std::string> assignments(std::size_t point) const
    {
        std::vector<std::string> all;
        const std::vector<std::string> values = points.values(point);
        for (std::size_t v = 0; v < values.size(); ++v)
            for (const std::string& path : study.variables[v].paths)
                all.push_back(path + '=' + values[v]);
        return all;
    }

    std::string key(std::size_t point) const;
    const ControlTrack& controlsOf(std::size_t point) const;
};

// Refuses with a sentence what cannot be: files that cannot be read, properties, values and probes
// that are not there. Nothing is flown.
//   design  in place of the scene that the study names: that of before (ledger.h)
Result<OpenedStudy> openStudy(const std::filesystem::path& file,
                              const std::optional<std::filesystem::path>& design = std::nullopt);

// Likewise one that is in no file yet.
//   file  that it is to be in, which messages name
Result<OpenedStudy> openStudy(Study study, const std::filesystem::path& file,
                              const std::optional<std::filesystem::path>& design = std::nullopt);

// The scene of a point. Fails when a value cannot be set.
Result<Scene> sceneOf(const OpenedStudy& opened, std::size_t point);

} // namespace ripstop
