// Reads, writes and replays control tracks.
//
// Reading goes line by line: addRow() takes a row for one of a hand when its second cell begins
// with "@", otherwise commandOf() splits it at the first and the last comma, so that a name may
// hold commas. Both lists are then sorted by time, and rows of equal times keep their order.
// Writing merges the two lists by time, commands first where times are equal, and names a control
// by its id where its name would not lead back to it. ControlPlayer gives what is due less than
// half a time step from now, so that rounding of times does not move it to another step.
#include "io/control_track.h"

#include "io/csv.h"
#include "io/hand_rows.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "scene/property.h"
#include "simulation/commands.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

std::string numberText(std::uint32_t id) { return std::string(1, '#').append(std::to_string(id)); }

// The id, or how the message goes on.
Result<std::uint32_t> controlOf(const Scene& scene, std::string_view name)
{
    std::vector<std::string_view> names;
    for (const Entry& entry : scene.items)
        if (const Control* control = std::get_if<Control>(&entry.item)) {
            const auto id = std::uint32_t(entry.id);
            if (control->name == name || name == numberText(id))
                return id;
            names.push_back(control->name);
        }
    const std::string_view near = nearest(name, names);
    if (!near.empty())
        return Failure("there is no control \"%1\"; did you mean \"%2\"?", name, near);
    return names.empty() ? Failure("there is no control \"%1\"; the scene has none.", name)
                         : Failure("there is no control \"%1\".", name);
}

// The name, where it tells the control from all others.
std::string nameOf(const Scene& scene, std::uint32_t id)
{
    std::string name;
    for (const Entry& entry : scene.items)
        if (const Control* control = std::get_if<Control>(&entry.item);
            control && std::uint32_t(entry.id) == id)
            name = control->name;
    const bool isPlain = !name.empty() && name == cellContent(name)
                         && name.find_first_of("\"#\n\r") == name.npos && !isHandRow(name);
    const Result<std::uint32_t> found = controlOf(scene, name);
    return isPlain && found && *found == id ? name : numberText(id);
}

Result<ControlCommand> commandOf(const Scene& scene, std::string_view line)
{
    const auto first = line.find(',');
    const auto last = line.rfind(',');
    if (first == std::string_view::npos || first == last)
        return Failure{"write TIME,CONTROL,VALUE."};
    const std::optional<double> time = cellNumber(line.substr(0, first));
    const std::optional<double> value = cellNumber(line.substr(last + 1));
    if (!time || !value)
        return Failure{"time (s) and value (m) must be finite numbers."};
    const Result<std::uint32_t> control =
        controlOf(scene, cellContent(line.substr(first + 1, last - first - 1)));
    if (!control)
        return control.failure();
    return ControlCommand{*time, *control, *value};
}

std::optional<Failure> addRow(const Scene& scene, std::string_view line, ControlTrack& track)
{
    const std::string_view rest = line.substr(std::min(line.size(), line.find(',')));
    if (rest.empty() || !isHandRow(cellContent(rest.substr(1)))) {
        const Result<ControlCommand> command = commandOf(scene, line);
        if (!command)
            return command.failure();
        track.commands.push_back(*command);
        return std::nullopt;
    }
    const std::optional<double> time = cellNumber(line.substr(0, line.find(',')));
    if (!time)
        return Failure{"time (s) must be a finite number."};
    Result<HandNote::What> what = handOf(rest.substr(1));
    if (!what)
        return what.failure();
    HandNote& note = track.hands.emplace_back();
    note.time = *time;
    note.what = *what;
    return std::nullopt;
}

template <typename Note>
std::vector<Note> inOrder(const std::vector<Note>& notes)
{
    std::vector<std::size_t> order(notes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return notes[a].time < notes[b].time; });
    std::vector<Note> sorted;
    sorted.reserve(notes.size());
    for (const std::size_t i : order)
        sorted.push_back(notes[i]);
    return sorted;
}

void appendCommand(std::string& text, const Scene& scene, const ControlCommand& command)
{
    appendNumber(text, command.time);
    text += ',';
    text += csvCell(nameOf(scene, command.control));
    text += ',';
    appendNumber(text, command.value);
    text += '\n';
}

} // namespace

Result<ControlTrack> readControlTrack(const std::filesystem::path& file, const Scene& scene)
{
    const Result<std::string> text =
        readWholeFile(file, [](std::string_view) { return std::nullopt; });
    if (!text)
        return text.failure();
    if (text->find_first_not_of(" \t\r\n") == std::string::npos) // no commands have a heading
        return Failure("%1 is empty: a table of time (s), control and value (m) is wanted.",
                       file.string());
    ControlTrack track;
    std::string_view rest = *text;
    for (int number = 1; !rest.empty(); ++number) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const bool heading = number == 1 && !cellNumber(line.substr(0, line.find(','))).has_value();
        if (heading || cellContent(line).empty())
            continue;
        if (const auto failure = addRow(scene, line, track))
            return Failure("%1, line %2: %3", file.string(), number, failure->message);
    }
    return {ControlTrack{inOrder(track.commands), inOrder(track.hands)}};
}

std::optional<Failure> writeControlTrack(const Scene& scene, const ControlTrack& track,
                                         const std::filesystem::path& file)
{
    std::string text = "time (s),control,value (m)\n";
    auto next = track.commands.begin();
    for (const HandNote& note : track.hands) {
        for (; next != track.commands.end() && next->time <= note.time; ++next)
            appendCommand(text, scene, *next);
        appendNumber(text, note.time);
        text += ',';
        appendHandRow(text, note.what);
        text += '\n';
    }
    for (; next != track.commands.end(); ++next)
        appendCommand(text, scene, *next);
    return replaceFile(file, text);
}

ControlTrack trackOf(const Frame& frame) { return {frame.commands, frame.hands.notes()}; }

void ControlPlayer::giveTo(Simulation& simulation)
{
    const double now = simulation.state().time + 0.5 * simulation.system().timeStep;
    Commands commands;
    for (; m_nextCommand < m_track.commands.size() && m_track.commands[m_nextCommand].time < now;
         ++m_nextCommand)
        commands[m_track.commands[m_nextCommand].control] = m_track.commands[m_nextCommand].value;
    if (!commands.empty())
        simulation.command(commands);
    // one by one: a cut before a pin is not a cut after it
    for (; m_nextHand < m_track.hands.size() && m_track.hands[m_nextHand].time < now;
         ++m_nextHand) {
        add(m_track.hands[m_nextHand].what, m_hands);
        simulation.handle(m_hands);
    }
}

} // namespace ripstop
