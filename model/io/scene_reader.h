// Reads the text of a scene, event by event, straight into its tables. The first thing that is
// wrong ends the reading and is a Flaw; scene_file.h makes a message of it.
#pragma once

#include "io/json_events.h"
#include "scene/property.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// An item or element, and where in the text its object begins.
struct Written
{
    Id id;
    std::optional<Kind> kind; // nothing for an item of a type that is not known
    std::size_t begin;

    std::string_view name() const { return kind ? kindName(*kind) : "item of an unknown type"; }
};

// What is wrong, as a sentence without its place, at the event with this `end`.
struct Flaw
{
    std::size_t end;
    std::string message;
};

struct SceneDraft
{
    Scene scene;
    std::vector<Written> written; // in the order of the text
    std::optional<Flaw> flaw;
};

// Ids in a file lie from 1 to this; it leaves room for new ones above.
inline constexpr std::uint32_t largestId = 4'000'000'000;

// Everything but the references between things; `text` starts with an object.
SceneDraft readDraft(std::string_view text);

// Ids used twice, and references to nothing or to the wrong kind. Sorts `draft.written`.
std::optional<Flaw> referenceFlaw(SceneDraft& draft, std::string_view text);

} // namespace ripstop
