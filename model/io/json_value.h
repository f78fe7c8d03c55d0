// Between the values of properties and JSON: events become values, and values become text. Whether
// a value is allowed is not decided here but by refusal().
#pragma once

#include "io/json_events.h"
#include "scene/property.h"

#include <string>
#include <string_view>

namespace ripstop {

// A single value in the type of the property, or one of another type when that cannot be, which
// refusal() then explains.
Value valueFromEvent(const Property& property, const JsonEvent& event);

// The value as a message shows it; `text` is what the event comes from.
std::string shown(const JsonEvent& event, std::string_view text);

// With quotation marks, and cut when it is long.
std::string quoted(std::string_view text);

void appendValue(std::string& text, const Value& value);

// Equal to the last bit, so that a value that is left out comes back as it was. (Zero equals
// minus zero otherwise.)
bool sameBits(const Value& a, const Value& b);

} // namespace ripstop
