// manifestText() writes the fields in a fixed order, and the files by name, so that equal manifests
// are equal texts. readManifest() reads them back: parsed() checks format and version before any
// field, since only then a missing field is a fault, and readManifest() puts the name of the file
// before what parsed() says.
//
// filesIn() walks a folder, the same way for writing a bundle and for checking one. It takes the
// size of each file and the checksum of its content, but leaves out the sum of the recording, which
// has its own, and the manifest, which cannot hold its own sum.
#include "bundle/manifest.h"

#include "base/hash_text.h"
#include "io/whole_file.h"
#include "recording/packed.h"

#include <nlohmann/json.hpp>

namespace ripstop {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* formatName = "ripstop-bundle";
constexpr int formatVersion = 1;

Result<std::string> contentOf(const fs::path& file)
{
    return readWholeFile(file, [](std::string_view) { return std::optional<Message>(); });
}

// A failure is half a sentence.
Result<Manifest> parsed(const std::string& text)
{
    const Json json = Json::parse(text, nullptr, false);
    const auto says = [&](const char* key, const Json& value) {
        return json.contains(key) && json[key] == value;
    };
    if (!json.is_object() || !says("format", formatName))
        return Failure{"is no manifest of a bundle"};
    if (!says("version", formatVersion))
        return Failure{"was written by a later version of Ripstop; use that"};
    Manifest manifest;
    try {
        manifest.program = json.at("program");
        manifest.title = json.at("title");
        manifest.from = json.at("flown_from") == "recording" ? Manifest::From::Recording
                                                             : Manifest::From::Scene;
        manifest.begin = json.at("begin");
        manifest.end = json.at("end");
        manifest.timeStep = json.at("time_step");
        manifest.steps = json.at("steps");
        manifest.hashAtStart = json.at("hash_at_start");
        manifest.hashAtEnd = json.at("hash_at_end");
        manifest.stopped = json.at("stopped");
        manifest.commands = json.at("commands");
        for (const auto& [name, file] : json.at("files").items())
            manifest.files[name] = {file.at("bytes"), file.at("sum")};
    } catch (const Json::exception&) {
        return Failure{"lacks something that a manifest has"};
    }
    return manifest;
}

} // namespace

std::string manifestText(const Manifest& manifest)
{
    Json json = {{"format", formatName},
                 {"version", formatVersion},
                 {"program", manifest.program},
                 {"title", manifest.title},
                 {"flown_from", manifest.from == Manifest::From::Scene ? "scene" : "recording"},
                 {"begin", manifest.begin},
                 {"end", manifest.end},
                 {"time_step", manifest.timeStep},
                 {"steps", manifest.steps},
                 {"hash_at_start", manifest.hashAtStart},
                 {"hash_at_end", manifest.hashAtEnd},
                 {"stopped", manifest.stopped},
                 {"commands", manifest.commands},
                 {"files", Json::object()}};
    for (const auto& [name, file] : manifest.files)
        json["files"][name] = {{"bytes", file.bytes}, {"sum", file.sum}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<Manifest> readManifest(const fs::path& folder)
{
    const fs::path file = folder / bundled::manifest;
    const auto text = contentOf(file);
    if (!text)
        return text.failure();
    auto manifest = parsed(*text);
    if (!manifest)
        return Failure("%1 %2.", file.string(), manifest.message());
    return manifest;
}

Result<std::map<std::string, Manifest::File>> filesIn(const fs::path& folder)
{
    std::map<std::string, Manifest::File> files;
    std::error_code error;
    for (auto entry = fs::recursive_directory_iterator(folder, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (!entry->is_regular_file())
            continue;
        const std::string name = entry->path().lexically_relative(folder).generic_string();
        if (name == bundled::manifest)
            continue;
        Manifest::File& file = files[name];
        file.bytes = entry->file_size(error);
        if (name == bundled::recording)
            continue;
        const auto content = contentOf(entry->path());
        if (!content)
            return content.failure();
        file.sum = hashText(checksum(*content));
    }
    if (error)
        return Failure("%1 cannot be read: %2.", folder.string(), error.message());
    return files;
}

} // namespace ripstop
