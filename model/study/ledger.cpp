// FlightKeys hashes what all flights have in common once, and adds what is set in each. Ledger
// writes each line by one call of the system to a file that is opened for appending, which puts it
// whole behind whatever else is there; readLedgers() reads all lines of all files in the order of
// their names.
#include "study/ledger.h"

#include "base/hash_text.h"
#include "base/program_version.h"
#include "io/json_text.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "recording/packed.h"
#include "shapes/shape_files.h"
#include "study/study.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace ripstop {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* ledgerEnding = ".jsonl";

Result<std::string> wholeContent(const fs::path& file)
{
    return readWholeFile(file, [](std::string_view) { return std::optional<Message>(); });
}

// A text and its length, so that no two lists of texts look the same.
void append(std::string& all, std::string_view text)
{
    all += std::to_string(text.size()) + ':';
    all += text;
}

void appendField(std::string& line, const char* name, double value)
{
    line += std::string(",\"") + name + "\":";
    appendNumber(line, value);
}

void appendField(std::string& line, const char* name, const std::string& value)
{
    line += std::string(",\"") + name + "\":";
    appendQuoted(line, value);
}

double numberIn(const Json& json)
{
    return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

// A whole number that is not negative, as far as doubles tell them apart; nothing where it is none.
std::optional<std::int64_t> countIn(const Json& json, const char* name)
{
    constexpr double most = 9007199254740992.0; // 2^53
    const double number = json.contains(name) ? numberIn(json[name]) : -1.0;
    if (!(number >= 0.0 && number <= most) || number != std::floor(number))
        return std::nullopt;
    return std::int64_t(number);
}

// Nothing when the line is no whole row.
std::optional<std::pair<std::string, FlightResult>> rowOf(const Json& json)
{
    const auto text = [&](const char* name) {
        return json.contains(name) && json[name].is_string() ? json[name].get<std::string>()
                                                             : std::string();
    };
    const auto number = [&](const char* name) {
        return json.contains(name) ? numberIn(json[name]) : std::nan("");
    };
    const auto steps = countIn(json, "steps"), torn = countIn(json, "torn");
    const bool isWhole = json.contains("measured") && json["measured"].is_array() && steps && torn;
    if (!isWhole || text("key").empty())
        return std::nullopt;
    FlightResult flight;
    flight.time = number("time");
    flight.steps = *steps;
    flight.hash = text("hash");
    flight.torn = std::size_t(*torn);
    flight.firstTear = number("first_tear");
    flight.firstTearLoad = number("first_tear_load");
    flight.firstTearUnit = text("first_tear_unit");
    flight.firstTorn = std::uint32_t(countIn(json, "first_torn").value_or(0));
    flight.stopped = text("stopped");
    flight.absurd = text("absurd");
    flight.inaccurate = text("inaccurate");
    for (const Json& value : json["measured"])
        flight.measured.push_back(numberIn(value));
    return std::pair(text("key"), std::move(flight));
}

std::string thisProgram() { return "Ripstop " + programVersion(); }

//   other  the program of another build that writes, or empty; a heading says whose lines come
void takeLine(std::string_view line, LedgerContent& content, std::string& other)
{
    if (line.empty())
        return;
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_object() && json.contains("measures")) { // a heading, for people
        const auto design = json.find("design");
        if (design != json.end() && design->is_string())
            content.designs.push_back(design->get<std::string>());
        other = json.contains("program") && json["program"].is_string()
                    ? json["program"].get<std::string>()
                    : "";
        if (other == thisProgram())
            other.clear();
        return;
    }
    auto row = json.is_object() ? rowOf(json) : std::nullopt;
    if (!row) {
        ++content.torn;
        return;
    }
    if (!other.empty()) {
        ++content.other.rows;
        content.other.program = other;
    }
    const std::string hash = row->second.hash;
    const auto [place, isNew] = content.rows.insert(std::move(*row));
    content.differing += !isNew && place->second.hash != hash;
}

Failure cannotWrite(const fs::path& file)
{
    return Failure("%1 cannot be written: %2.", file.string(), std::strerror(errno));
}

} // namespace

Result<FlightKeys> FlightKeys::of(const Scene& scene, const fs::path& controls,
                                  const FlightPlan& plan)
{
    std::string common;
    append(common, programVersion()); // another build may fly otherwise
    append(common, "accuracy");       // rows of before did not say whether it was held
    std::string design = sceneText(scene);
    append(common, design);
    for (const Entry& entry : scene.items)
        if (const auto* collider = std::get_if<Collider>(&entry.item);
            collider && !collider->file.empty()) {
            const auto content = wholeContent(placeOfFile(scene.folder.path, collider->file));
            if (!content)
                return content.failure();
            append(common, *content);
            append(design, *content);
        }
    if (!controls.empty()) {
        const auto content = wholeContent(controls);
        if (!content)
            return content.failure();
        append(common, *content);
    }
    std::string end;
    appendNumber(end, plan.seconds);
    append(common, end + (plan.untilTear ? " or tear" : ""));
    for (const Measure& measure : plan.measures)
        append(common, headingOf(measure, {}));
    FlightKeys keys;
    keys.m_common = hashText(checksum(common));
    keys.m_design = hashText(checksum(design));
    return keys;
}

std::string FlightKeys::of(const std::vector<std::string>& assignments) const
{
    std::string all;
    for (const std::string& assignment : assignments)
        append(all, assignment);
    return m_common + hashText(checksum(all));
}

fs::path ledgerFolder(const fs::path& study)
{
    std::string name = study.filename().string();
    if (name.ends_with(studyEnding))
        name.resize(name.size() - studyEnding.size());
    return study.parent_path() / (name + ".ripstop-runs");
}

Result<std::string> hashOfFile(const fs::path& file)
{
    const auto content = wholeContent(file);
    if (!content)
        return content.failure();
    return hashText(checksum(*content));
}

fs::path keptDesign(const fs::path& folder, const std::string& hash)
{
    return folder / ("design-" + hash + ".ripstop.json");
}

Result<LedgerContent> readLedgers(const fs::path& folder)
{
    LedgerContent content;
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == ledgerEnding)
            files.push_back(it->path());
    std::ranges::sort(files);
    for (const fs::path& file : files) {
        const auto text = wholeContent(file);
        if (!text)
            return text.failure();
        std::string other;
        std::string_view rest = *text;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            takeLine(rest.substr(0, end), content, other);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return content;
}

Ledger::Ledger(fs::path file, int descriptor)
    : m_file(std::move(file))
    , m_descriptor(descriptor)
{}

Ledger::Ledger(Ledger&& other) noexcept
    : m_file(std::move(other.m_file))
    , m_descriptor(std::exchange(other.m_descriptor, -1))
{}

Ledger::~Ledger()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

Result<Ledger> Ledger::open(const fs::path& folder, const std::string& shard,
                            const std::vector<std::string>& headings, const std::string& design)
{
    std::error_code error;
    fs::create_directories(folder, error);
    const fs::path file = folder / (shard + ledgerEnding);
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0)
        return cannotWrite(file);
    Ledger ledger(file, descriptor);
    std::string heading = "\n{\"program\":\"" + thisProgram() + "\",\"design\":\"" + design
                          + "\",\"measures\":[";        // ends
    for (std::size_t i = 0; i < headings.size(); ++i) { // what a killed process began
        heading += i ? "," : "";
        appendQuoted(heading, headings[i]);
    }
    if (auto failure = ledger.write(heading + "]}\n"))
        return *failure;
    return ledger;
}

std::optional<Failure> Ledger::add(const std::string& key, const FlightResult& flight)
{
    std::string line = "{\"key\":";
    appendQuoted(line, key);
    appendField(line, "time", flight.time);
    appendField(line, "steps", double(flight.steps));
    appendField(line, "hash", flight.hash);
    appendField(line, "torn", double(flight.torn));
    appendField(line, "first_tear", flight.firstTear);
    appendField(line, "first_tear_load", flight.firstTearLoad);
    appendField(line, "first_tear_unit", flight.firstTearUnit);
    appendField(line, "first_torn", double(flight.firstTorn));
    appendField(line, "stopped", flight.stopped);
    appendField(line, "absurd", flight.absurd);
    appendField(line, "inaccurate", flight.inaccurate);
    line += ",\"measured\":[";
    for (std::size_t i = 0; i < flight.measured.size(); ++i) {
        line += i ? "," : "";
        appendNumber(line, flight.measured[i]);
    }
    return write(line + "]}\n");
}

std::optional<Failure> Ledger::write(std::string_view line)
{
    const ssize_t written = ::write(m_descriptor, line.data(), line.size());
    if (written == ssize_t(line.size()))
        return std::nullopt;
    if (written >= 0)
        errno = ENOSPC;
    return cannotWrite(m_file);
}

} // namespace ripstop
