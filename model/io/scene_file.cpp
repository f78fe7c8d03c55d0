// Reads and saves scenes.
//
// parseScene() goes from the coarse to the fine, so that the message names the true cause: the
// first character, an empty file, format and version, then the content, then references. Each flaw
// has only its place as an offset; failureAt() walks the text again for line and path. saveScene()
// first asks each property for refusal(), as readScene() would refuse what it wrote, and then
// replaces the file. sceneText() is in scene_writer.cpp.
#include "io/scene_file.h"

#include "io/json_place.h"
#include "io/json_text.h"
#include "io/scene_reader.h"
#include "io/whole_file.h"

#include <cmath>
#include <new>

namespace ripstop {
namespace {

constexpr int version = 1; // of the format that is written, and the newest that is read
constexpr std::string_view formatName = "ripstop-scene";

// Without the mark that some editors put before UTF-8, which no JSON has.
std::string_view withoutMark(std::string_view text)
{
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

// Why a text that begins like this is no scene, as the rest of a sentence.
std::optional<Message> wrongStart(std::string_view start)
{
    start = withoutMark(start);
    const auto first = start.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || start[first] == '{')
        return std::nullopt;
    return Message("is not a scene: a scene file starts with '{'; choose a file that ends in %1",
                   sceneExtension);
}

// Format and version, wherever they stand.
std::optional<Flaw> headerFlaw(std::string_view text)
{
    using Type = JsonEvent::Type;
    const std::optional<JsonMember> format = findMember(text, 0, "format");
    if (format && format->type == Type::Error)
        return std::nullopt; // told of when the whole is read
    if (!format)
        return Flaw{1, "is not a scene: it lacks \"format\": \"ripstop-scene\"; choose a file that "
                       "was saved by Ripstop"};
    if (format->type != Type::Text || format->text != formatName)
        return Flaw{format->end,
                    "must be \"ripstop-scene\"; choose a file that was saved by Ripstop"};

    const std::optional<JsonMember> found = findMember(text, 0, "version");
    if (found && found->type == Type::Error)
        return std::nullopt;
    if (!found)
        return Flaw{1, "lacks the version of its format; add \"version\": 1"};
    if (found->type == Type::Number && found->number > version)
        return Flaw{found->end, "is newer than the " + std::to_string(version)
                                    + " that this program can read; update Ripstop"};
    if (found->type != Type::Number || found->number != version)
        return Flaw{found->end, "must be 1"};
    return std::nullopt;
}

Failure failureAt(std::string_view fileName, std::string_view text, const Flaw& flaw)
{
    const JsonPlace place = placeOf(text, flaw.end);
    std::string message = std::string(fileName) + ", line " + std::to_string(place.line);
    message += place.path.empty() ? ": the file " : ", " + place.path + ": ";
    return Failure(Message::verbatim(printable(message + flaw.message + ".")));
}

Message nameOfThing(Id id, Kind kind)
{
    const Message name = Message::word(kindName(kind));
    return kind == Kind::Settings ? name : Message("%1 %2", name, std::uint32_t(id));
}

// A scene that could not be read again must not replace one that can.
std::optional<Failure> unwritable(const Scene& scene, const std::filesystem::path& file)
{
    std::optional<Failure> failure;
    const auto check = [&](Id id, const ConstRef& ref) {
        for (const Property& property : propertiesOf(kindOf(ref))) {
            if (const auto reason = refusal(property, property.get(ref)))
                failure = Failure("%1 was not saved: %2 of %3 %4; correct it first.", file.string(),
                                  property.key, nameOfThing(id, kindOf(ref)), *reason);
        }
    };
    check(settingsId, &scene.settings);
    for (const Entry& entry : scene.items) {
        std::visit([&](const auto& item) { check(entry.id, &item); }, entry.item);
        if (const Part* part = std::get_if<Part>(&entry.item)) {
            for (const auto& [key, value] : part->parameters)
                if (!std::isfinite(value))
                    failure =
                        Failure("%1 was not saved: parameter %2 of %3 is not a finite number; "
                                "correct it first.",
                                file.string(), key, part->name);
            for (const Particle& row : part->particles)
                check(row.id, &row);
            for (const Link& row : part->links)
                check(row.id, &row);
        }
        if (failure)
            break;
    }
    return failure;
}

} // namespace

Result<Scene> parseScene(std::string_view text, std::string_view fileName)
{
    text = withoutMark(text);
    if (const auto reason = wrongStart(text))
        return Failure("%1, line 1: the file %2.", fileName, *reason);
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return Failure("%1, line 1: the file is empty; choose another or restore it from a copy.",
                       fileName);
    if (const auto flaw = headerFlaw(text))
        return failureAt(fileName, text, *flaw);
    SceneDraft draft = readDraft(text);
    if (!draft.flaw)
        draft.flaw = referenceFlaw(draft, text);
    if (draft.flaw)
        return failureAt(fileName, text, *draft.flaw);
    return std::move(draft.scene);
}

Result<Scene> readScene(const std::filesystem::path& file)
{
    try {
        const Result<std::string> text = readWholeFile(file, wrongStart);
        if (!text)
            return text.failure();
        Result<Scene> scene = parseScene(*text, file.string());
        if (scene)
            scene->folder.path = file.parent_path().string();
        return scene;
    } catch (const std::bad_alloc&) {
        return Failure("%1 is too large for the memory of this computer.", file.string());
    }
}

std::optional<Failure> saveScene(const Scene& scene, const std::filesystem::path& file)
{
    try {
        if (auto failure = unwritable(scene, file))
            return failure;
        return replaceFile(file, sceneText(scene, file.parent_path()));
    } catch (const std::bad_alloc&) {
        return Failure("%1 was not saved: not enough memory to write the scene.", file.string());
    }
}

} // namespace ripstop
