// A JSON text as a stream of events: nothing is kept, so a file of any size costs no memory, and
// deep nesting cannot overflow a stack.
//
// RapidJSON reads, and not simdjson, as that indexes a whole text before its first event: four
// bytes for each token, together nearly as much memory again as the text of a scene, and no place
// to tell of when it refuses the text there.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace ripstop {

struct JsonEvent
{
    enum class Type {
        Null,
        Boolean,
        Number,
        Text,
        Key,
        BeginObject,
        EndObject,
        BeginArray,
        EndArray,
        Error // the text is broken here; `text` says how, as a sentence. Always the last event.
    };

    Type type;
    bool boolean = false;
    double number = 0.0;
    std::string_view text{}; // Text, Key, Error; valid during the call
    std::size_t end = 0; // offset just behind the event, or behind the one character that follows
                         // a number

    bool begins() const { return type == Type::BeginObject || type == Type::BeginArray; }
    bool ends() const { return type == Type::EndObject || type == Type::EndArray; }
};

// False ends the walk.
using JsonVisitor = std::function<bool(const JsonEvent&)>;

// Walks one JSON value that starts at offset `begin`. With `whole`, only white space may follow it.
void walkJson(std::string_view text, std::size_t begin, bool whole, const JsonVisitor& visit);

// The characters of the number that a Number event tells of.
std::string_view numberText(std::string_view text, std::size_t end);

} // namespace ripstop
