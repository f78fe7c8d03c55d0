// Keeps keys and items of a scene file that this version does not know as text, so that they can be
// written back. The scene reader hands it the events of such a value.
#pragma once

#include "io/json_events.h"

#include <string>
#include <string_view>

namespace ripstop {

// Keeps a value that is not understood, with its key if it has one, as text in our own spelling.
class JsonCapture
{
public:
    // After a Key: the events up to the end of its value belong here. Returns true.
    bool start(std::string& into, std::string_view key);
    void start(std::string& into); // a value without a key
    bool active() const { return m_into != nullptr; }

    // `text` is what the events come from. Returns true.
    bool add(const JsonEvent& event, std::string_view text);

private:
    std::string* m_into = nullptr;
    std::size_t m_depth = 0;
    bool m_comma = false; // the next value needs one before it
};

} // namespace ripstop
