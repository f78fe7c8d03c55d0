#include "io/event_table.h"

#include "io/csv.h"
#include "io/json_text.h"
#include "io/whole_file.h"

namespace ripstop {
namespace {

std::string named(const Scene& scene, std::uint32_t id)
{
    const Item* item = findItem(scene, Id{id});
    return item ? nameOf(*item) : std::to_string(id);
}

} // namespace

std::string subjectOf(const RunEvent& event, const Scene& scene)
{
    switch (event.kind) {
    case RunEvent::Kind::Tear:
        return (isPanel(scene, Id{event.what}) ? "panel " : "link ") + std::to_string(event.what);
    case RunEvent::Kind::Slack:
    case RunEvent::Kind::Taut:
        return "link " + std::to_string(event.what);
    case RunEvent::Kind::Control:
        return named(scene, event.what);
    case RunEvent::Kind::Contact:
    case RunEvent::Kind::LiftOff:
        return named(scene, event.what) + ", " + named(scene, event.with);
    case RunEvent::Kind::Hand:
    case RunEvent::Kind::Edit:
    case RunEvent::Kind::Stopped:
        break;
    }
    return {};
}

std::optional<Failure> writeEvents(const Scene& scene, std::span<const RunEvent> events,
                                   const std::filesystem::path& file)
{
    std::string text = "time (s),step,event,subject,count\n";
    for (const RunEvent& event : events) {
        appendNumber(text, event.time);
        text += ',' + std::to_string(event.step) + ',';
        text += runEventNames[std::size_t(event.kind)];
        text += ',' + csvCell(subjectOf(event, scene)) + ',' + std::to_string(event.count) + '\n';
    }
    return replaceFile(file, text);
}

} // namespace ripstop
