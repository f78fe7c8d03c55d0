// Places in a JSON text, for messages. Nothing is noted while a file is read; when something is
// wrong, the text is walked again up to there.
#pragma once

#include "io/json_events.h"

#include <optional>
#include <string>
#include <string_view>

namespace ripstop {

struct JsonPlace
{
    std::size_t line; // from 1
    std::string path; // "items[0].links[3].from"; empty for the file as a whole
};

// The place of the event with this `end`.
JsonPlace placeOf(std::string_view text, std::size_t end);

// Where a character of a text stands.
struct TextPlace
{
    std::size_t line; // both from 1
    std::size_t column;
};
TextPlace textPlace(std::string_view text, std::size_t offset);

// Where the member or value of this path begins, the key first; without one of that path where that
// begins which would hold it.
std::size_t beginOfPath(std::string_view text, std::string_view path);

// The value of a key of the object that starts at `begin`.
struct JsonMember
{
    JsonEvent::Type type; // Error when the text is broken before the key is found
    double number = 0.0;
    std::string text;
    std::size_t end;
};
std::optional<JsonMember> findMember(std::string_view text, std::size_t begin,
                                     std::string_view key);

// The `end` of one value of the list under a key, or that of the object when there is none.
std::size_t endOfMember(std::string_view text, std::size_t begin, std::string_view key,
                        std::size_t index);

} // namespace ripstop
