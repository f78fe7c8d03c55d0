// In order: the small printers of rows, sentences and events; opening a file with a line of
// progress; the replay, which Ctrl-C may end early; what a replay has shown (tellReplay), which the
// command for bundles uses too; and the description of a recording, which is collected as JSON
// first so that both outputs say the same.
#include "cli/replay.h"

#include "base/hash_text.h"
#include "cli/certificate_text.h"
#include "io/event_table.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>

namespace ripstop {
namespace {

Json jsonOf(const ReplayDifference& difference)
{
    Json json = {{"step", difference.step},
                 {"time", difference.time},
                 {"recorded_hash", hashText(difference.recorded)},
                 {"computed_hash", hashText(difference.computed)},
                 {"particle", nullptr}};
    if (difference.seen) {
        json["particle"] = difference.seen->particle;
        json["distance"] = difference.seen->distance;
        json["seen_at_step"] = difference.seen->step;
    }
    return json;
}

std::string sentence(const ReplayDifference& difference)
{
    std::string text = "The replay differs from step " + std::to_string(difference.step) + " ("
                       + shortNumber(difference.time) + " s) on: ";
    if (!difference.seen)
        return text + "by less than the frames of the recording show.";
    return text + "particle " + std::to_string(difference.seen->particle) + " is "
           + shortNumber(difference.seen->distance) + " m off at step "
           + std::to_string(difference.seen->step) + ".";
}

void row(const std::string& label, const std::string& text)
{
    std::cout << label << std::string(24 - std::min<std::size_t>(label.size(), 23), ' ') << text
              << '\n';
}

std::string plural(std::size_t count, const std::string& noun)
{
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string megabytes(std::size_t bytes) { return shortNumber(double(bytes) / 1e6) + " MB"; }

// Prints the first events; --json and run --events have all of them.
void printEvents(const Json& events)
{
    constexpr std::size_t most = 30;
    for (std::size_t i = 0; i < std::min(most, events.size()); ++i) {
        const Json& event = events[i];
        const int count = event["count"].get<int>();
        row("  " + shortNumber(event["time"]) + " s",
            event["event"].get<std::string>() + "  " + event["subject"].get<std::string>()
                + (count > 1 ? ", " + std::to_string(count) + " in all" : ""));
    }
    if (events.size() > most)
        row("", "and " + std::to_string(events.size() - most) + " more");
}

} // namespace

OpenedRecording openOrSay(const std::string& file)
{
    ProgressLine progress("opening " + file);
    auto opened = openRecording(file, [&](double share) {
        progress.show(share);
        return !interrupted();
    });
    if (!opened) {
        (void)fail(BadInput, opened.message());
        return {};
    }
    if (!opened->damage.empty())
        (void)fail(BadInput, opened->damage);
    return std::move(*opened);
}

int replayFile(const std::string& file, int threads, bool json)
{
    const OpenedRecording opened = openOrSay(file);
    if (!opened.recording)
        return BadInput;
    ProgressLine progress(file);
    const auto outcome = replay(*opened.recording, threads, [&](double share) {
        progress.show(share);
        return !interrupted();
    });
    if (!outcome)
        return fail(Diverged, outcome.message());
    const int code = tellReplay(*outcome, json);
    return code == Done && !opened.damage.empty() ? BadInput : code; // that is said already
}

int tellReplay(const ReplayOutcome& outcome, bool json)
{
    if (json) {
        Json result = {{"steps", outcome.steps},
                       {"hash", hashText(outcome.hash)},
                       {"same", !outcome.difference && !outcome.cancelled},
                       {"difference", nullptr}};
        if (outcome.difference)
            result["difference"] = jsonOf(*outcome.difference);
        print(result);
    } else {
        row("replayed", plural(std::size_t(outcome.steps), "step"));
        row("hash", hashText(outcome.hash));
    }
    if (outcome.difference)
        return fail(Differs, sentence(*outcome.difference));
    if (outcome.cancelled)
        return fail(Interrupted, "Interrupted; all steps up to then are the same.");
    if (!json)
        row("result", "the same bits in every step");
    return Done;
}

std::optional<Failure> saveRun(const std::shared_ptr<Recording>& recording, const std::string& file)
{
    if (!recording)
        return Failure("%1 was not written: no step was made.", file);
    recording->setName(std::filesystem::path(file).stem().string());
    ProgressLine progress("saving " + file);
    const auto failure = saveRecording(*recording, file, [&](double share) {
        progress.show(share);
        return true;
    });
    if (!failure && !recording->trouble().empty())
        return Failure("%1: %2", file, recording->trouble());
    return failure;
}

int describeRecording(const std::string& file, bool json)
{
    const auto recording = openOrSay(file).recording;
    if (!recording)
        return BadInput;
    const std::size_t frames = recording->frameCount();
    std::map<std::string, std::size_t> events;
    Json list = Json::array();
    const Scene scene = recording->scene();
    for (const RunEvent& event : recording->events()) {
        const std::string kind(runEventNames[std::size_t(event.kind)]);
        events[kind] += std::size_t(event.count);
        list.push_back({{"time", event.time},
                        {"step", event.step},
                        {"event", kind},
                        {"subject", subjectOf(event, scene)},
                        {"count", event.count}});
    }
    Json info = {{"name", recording->name()},
                 {"title", scene.settings.title},
                 {"origin", recording->origin()},
                 {"from", recording->timeOf(0)},
                 {"to", recording->timeOf(frames - 1)},
                 {"steps", recording->lastStep() - recording->firstStep()},
                 {"frames", frames},
                 {"exact_states", recording->chunkCount()},
                 {"designs", recording->designCount()},
                 {"inputs", recording->inputs().size()},
                 {"events", events},
                 {"hash", hashText(recording->hashOf(recording->lastStep()))},
                 {"bytes", recording->size().disk}};
    info["event_list"] = std::move(list);
    info["bookmarks"] = Json::array();
    for (const Bookmark& bookmark : recording->bookmarks())
        info["bookmarks"].push_back({{"time", bookmark.time}, {"name", bookmark.name}});
    const auto certificate = recording->certificate();
    info["certificate"] = certificate ? jsonOf(*certificate) : Json();
    if (json) {
        print(info);
        return Done;
    }
    const auto text = [&](const char* key) { return info[key].get<std::string>(); };
    row("recording", text("name").empty() ? file : text("name"));
    row("of the scene", text("title"));
    if (!recording->origin().empty())
        row("branched off at", text("origin"));
    row("time", shortNumber(info["from"]) + " s to " + shortNumber(info["to"]) + " s, "
                    + plural(info["steps"].get<std::size_t>(), "step"));
    row("frames", plural(frames, "frame") + ", " + plural(recording->chunkCount(), "exact state"));
    row("designs", plural(recording->designCount(), "design"));
    row("inputs", plural(info["inputs"].get<std::size_t>(), "input"));
    for (const auto& [name, count] : events)
        row("events: " + name, std::to_string(count));
    printEvents(info["event_list"]);
    for (const Bookmark& bookmark : recording->bookmarks())
        row("bookmark", shortNumber(bookmark.time) + " s " + bookmark.name);
    row("hash at the end", text("hash"));
    row("frames take", megabytes(recording->size().disk));
    if (certificate) {
        row("certified", "after " + shortNumber(certificate->seconds) + " s");
        printTable(*certificate);
    }
    return Done;
}

} // namespace ripstop
