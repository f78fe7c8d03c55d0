// A recording is removed when its flight is in the rows and not among the best of them: more rows
// can only put it further behind, so that shards do not have to wait for each other. One whose
// flight is in no row may be of a shard that knows more, or of a study as it was before.
#include "study/kept_runs.h"

#include "base/hash_text.h"
#include "io/recording_file.h"
#include "study/many.h"
#include "study/probe_names.h"
#include "study/study_search.h"

#include <mutex>
#include <set>

namespace ripstop {
namespace {

namespace fs = std::filesystem;

bool isThere(const fs::path& file)
{
    std::error_code error;
    return fs::exists(file, error);
}

std::vector<std::size_t> bestOf(const OpenedStudy& opened, const StudyFlights& flights)
{
    return bestDesigns(opened, flights, std::size_t(opened.study.keepCount));
}

// The keys of all recordings in the folder.
std::set<std::string> recordedKeys(const fs::path& folder)
{
    std::set<std::string> keys;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == recordingExtension)
            keys.insert(it->path().stem().string());
    return keys;
}

void removeAllBut(const std::vector<std::size_t>& best, const OpenedStudy& opened,
                  const StudyFlights& flights)
{
    std::set<std::string> keys = recordedKeys(ledgerFolder(opened.file));
    for (const std::size_t point : best)
        keys.erase(opened.key(point));
    for (std::size_t i = 0; i < flights.size() && !keys.empty(); ++i)
        if (flights[i] && keys.erase(opened.key(i)) > 0) {
            std::error_code error; // another shard may have removed it
            fs::remove(keptRun(opened, i), error);
        }
}

std::vector<std::size_t> thoseThere(std::vector<std::size_t> best, const OpenedStudy& opened)
{
    std::erase_if(best, [&](std::size_t point) { return !isThere(keptRun(opened, point)); });
    return best;
}

} // namespace

fs::path keptRun(const OpenedStudy& opened, std::size_t point)
{
    return ledgerFolder(opened.file) / (opened.key(point) + std::string(recordingExtension));
}

std::optional<RecordedFlight> readKeptRun(const OpenedStudy& opened, std::size_t point,
                                          const FlightResult& row)
{
    const fs::path file = keptRun(opened, point);
    if (!isThere(file))
        return std::nullopt;
    const auto found = openRecording(file);
    if (!found || found->recording->frameCount() == 0)
        return std::nullopt;
    RecordedFlight kept{row, found->recording, {}};
    const Recording& recording = *kept.recording;
    if (hashText(recording.hashOf(recording.lastStep())) != row.hash)
        return std::nullopt;
    for (std::size_t i = 0; i < recording.frameCount(); ++i) {
        const auto frame = recording.frame(i);
        if (!frame)
            return std::nullopt;
        kept.curves.take({0, (*frame)->layout, (*frame)->time, (*frame)->probe});
        kept.flight.probes = (*frame)->layout->probes;
    }
    const std::vector<std::string> names = distinctNames(kept.flight.probes);
    for (std::size_t i = 0; i < names.size(); ++i)
        kept.flight.probes[i].name = names[i];
    return kept;
}

Result<std::vector<std::size_t>> settleBest(const OpenedStudy& opened, const StudyFlights& flights,
                                            int jobs, const std::function<bool()>& isInterrupted,
                                            const ToldOfRecordings& told)
{
    const std::vector<std::size_t> best = bestOf(opened, flights);
    std::vector<std::size_t> missing = best;
    std::erase_if(missing, [&](std::size_t point) { return isThere(keptRun(opened, point)); });
    std::optional<Failure> failure;
    std::size_t done = 0;
    std::mutex mutex;
    if (!missing.empty())
        told(done, missing.size());
    forEachOfMany(missing.size(), jobs, [&](std::size_t i) {
        const auto flown = flyRecorded(opened, missing[i], isInterrupted);
        if (!flown)
            return false;
        const auto trouble = flown->recording
                                 ? saveRecording(*flown->recording, keptRun(opened, missing[i]))
                                 : std::nullopt;
        const std::lock_guard lock(mutex);
        if (trouble && !failure)
            failure = *trouble;
        told(++done, missing.size());
        return !failure;
    });
    if (failure)
        return *failure;
    removeAllBut(best, opened, flights);
    return thoseThere(best, opened);
}

std::vector<std::size_t> removeOvertaken(const OpenedStudy& opened, const StudyFlights& flights)
{
    std::vector<std::size_t> best = bestOf(opened, flights);
    removeAllBut(best, opened, flights);
    return thoseThere(std::move(best), opened);
}

} // namespace ripstop
