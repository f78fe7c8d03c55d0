// Finds places by walking the text anew.
//
// placeOf() counts lines before the end of an event, and keeps one Level for each object or list
// that is open, with its last key or its count of values; at the event, pathOf() writes the levels
// as a path. findMember() and endOfMember() count only the depth, so that keys of inner objects are
// not taken for those of the object that they look in.
#include "io/json_place.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace ripstop {
namespace {

using Type = JsonEvent::Type;

constexpr std::size_t longestPath = 8; // levels; a scene has six

struct Level
{
    bool array;
    std::size_t count = 0; // values so far
    std::string key{};
};

void appendKey(std::string& path, std::string_view key)
{
    constexpr std::size_t longest = 40;
    const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '_' || c == '-';
    });
    if (plain)
        path += path.empty() ? "" : ".";
    else
        path += "[\"";
    path += key.substr(0, longest);
    path += key.size() > longest ? "..." : "";
    path += plain ? "" : "\"]";
}

// `open`: the innermost level has no value that the place is in.
std::string pathOf(const std::vector<Level>& levels, bool open)
{
    std::string path;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (open && i + 1 == levels.size())
            break;
        if (i == longestPath)
            return path + "...";
        if (levels[i].array)
            path.append("[").append(std::to_string(levels[i].count - 1)).append("]");
        else
            appendKey(path, levels[i].key);
    }
    return path;
}

} // namespace

TextPlace textPlace(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, offset);
    const std::size_t lineBreak = before.rfind('\n');
    return {std::size_t(std::count(before.begin(), before.end(), '\n')) + 1,
            before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1};
}

std::size_t beginOfPath(std::string_view text, std::string_view path)
{
    std::vector<Level> levels;
    std::size_t found = 0, longest = 0, before = 0; // before: where the last event ended
    walkJson(text, 0, false, [&](const JsonEvent& event) {
        const std::size_t begin = text.find_first_not_of(" \t\r\n,:", before);
        before = event.end;
        if (event.ends())
            levels.pop_back();
        else if (event.type == Type::Key)
            levels.back().key = event.text;
        else if (event.type != Type::Error && !levels.empty())
            ++levels.back().count;
        if (event.type == Type::Key || (!levels.empty() && levels.back().array && !event.ends())) {
            const std::string here = pathOf(levels, false);
            const bool holds = path.starts_with(here)
                               && (path.size() == here.size() || path[here.size()] == '.'
                                   || path[here.size()] == '[');
            if (holds && here.size() > longest) {
                longest = here.size();
                found = begin;
            }
        }
        if (event.begins())
            levels.push_back({.array = event.type == Type::BeginArray});
        return longest < path.size() && event.type != Type::Error;
    });
    return found;
}

JsonPlace placeOf(std::string_view text, std::size_t end)
{
    JsonPlace place{textPlace(text, end > 0 ? end - 1 : 0).line, {}};

    std::vector<Level> levels;
    Type last = Type::Null;
    walkJson(text, 0, false, [&](const JsonEvent& event) {
        if (event.ends()) {
            levels.pop_back();
        } else if (event.type == Type::Key) {
            levels.back().key = event.text;
        } else if (event.type != Type::Error && !levels.empty()) {
            ++levels.back().count;
        }
        if (event.end >= end || event.type == Type::Error) {
            place.path = pathOf(levels, event.type == Type::Error && last != Type::Key);
            return false;
        }
        if (event.begins())
            levels.push_back({.array = event.type == Type::BeginArray});
        last = event.type;
        return true;
    });
    return place;
}

std::optional<JsonMember> findMember(std::string_view text, std::size_t begin, std::string_view key)
{
    std::optional<JsonMember> found;
    int depth = 0;
    bool next = false;
    walkJson(text, begin, false, [&](const JsonEvent& event) {
        if (next || event.type == Type::Error) {
            found = {event.type, event.number, std::string(event.text), event.end};
            return false;
        }
        depth += int(event.begins()) - int(event.ends());
        next = depth == 1 && event.type == Type::Key && event.text == key;
        return true;
    });
    return found;
}

std::size_t endOfMember(std::string_view text, std::size_t begin, std::string_view key,
                        std::size_t index)
{
    std::size_t end = begin + 1;
    int depth = 0;
    bool inside = false;
    std::size_t count = 0;
    walkJson(text, begin, false, [&](const JsonEvent& event) {
        if (inside && !event.begins() && count++ == index) {
            end = event.end;
            return false;
        }
        depth += int(event.begins()) - int(event.ends());
        if (depth == 1 && event.type == Type::Key)
            inside = event.text == key;
        return depth > 0;
    });
    return end;
}

} // namespace ripstop
