// Carries values of properties between JSON and memory.
//
// valueFromEvent() makes the type that the property has where the event can be one, and otherwise a
// value of another type, so that refusal() alone words what is wrong; whole numbers beyond the
// range of int are clamped to it. shown() and quoted() are for messages and cut long text. Appender
// writes each alternative of a Value. sameBits() compares numbers and vectors by their bits and
// everything else by equality.
#include "io/json_value.h"

#include "io/json_text.h"

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t longestShown = 40; // characters

struct Appender
{
    std::string& text;

    void operator()(std::monostate) const { text += "null"; }
    void operator()(bool value) const { text += value ? "true" : "false"; }
    void operator()(int value) const { text += std::to_string(value); }
    void operator()(double value) const { appendNumber(text, value); }
    void operator()(const std::string& value) const { appendQuoted(text, value); }
    void operator()(const Vec3& value) const
    {
        text += '[';
        for (Eigen::Index i = 0; i < 3; ++i) {
            text += i == 0 ? "" : ", ";
            appendNumber(text, value[i]);
        }
        text += ']';
    }
    void operator()(Id value) const { text += std::to_string(std::uint32_t(value)); }
    void operator()(const std::vector<Id>& value) const
    {
        text += '[';
        for (std::size_t i = 0; i < value.size(); ++i) {
            text += i == 0 ? "" : ", ";
            (*this)(value[i]);
        }
        text += ']';
    }
    void operator()(const NumberRows& value) const
    {
        for (std::size_t i = 0; i < value.size(); ++i) {
            text += i == 0 ? "[[" : "], [";
            for (std::size_t k = 0; k < value[i].size(); ++k) {
                text += k == 0 ? "" : ", ";
                appendNumber(text, value[i][k]);
            }
        }
        text += value.empty() ? "[]" : "]]";
    }
};

bool sameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

} // namespace

Value valueFromEvent(const Property& property, const JsonEvent& event)
{
    using Type = JsonEvent::Type;
    const Value& initial = property.initial;
    const double number = event.number;
    const bool whole = number == std::floor(number);
    switch (event.type) {
    case Type::Null:
        return {};
    case Type::Boolean:
        return event.boolean;
    case Type::Text:
        return std::string(event.text);
    case Type::Number:
        if (std::holds_alternative<int>(initial) && whole)
            return int(std::clamp(number, double(INT_MIN), double(INT_MAX)));
        if (std::holds_alternative<Id>(initial) && whole && number >= 0.0 && number < 4294967295.0)
            return Id{std::uint32_t(number)};
        return number;
    default: // a list or an object where a single value belongs
        return std::holds_alternative<bool>(initial) ? Value(0) : Value(false);
    }
}

std::string shown(const JsonEvent& event, std::string_view text)
{
    using Type = JsonEvent::Type;
    switch (event.type) {
    case Type::Null:
        return "null";
    case Type::Boolean:
        return event.boolean ? "true" : "false";
    case Type::Number:
        return std::string(numberText(text, event.end).substr(0, longestShown));
    case Type::Text:
        return quoted(event.text);
    case Type::BeginArray:
        return "a list";
    default:
        return "an object";
    }
}

std::string quoted(std::string_view text)
{
    std::string result(1, '"');
    result.append(text.substr(0, longestShown));
    return result.append(text.size() > longestShown ? "...\"" : "\"");
}

void appendValue(std::string& text, const Value& value) { std::visit(Appender{text}, value); }

bool sameBits(const Value& a, const Value& b)
{
    if (a.index() != b.index())
        return false;
    if (const auto* number = std::get_if<double>(&a))
        return sameBits(*number, std::get<double>(b));
    if (const auto* vector = std::get_if<Vec3>(&a)) {
        const Vec3& other = std::get<Vec3>(b);
        return sameBits(vector->x(), other.x()) && sameBits(vector->y(), other.y())
               && sameBits(vector->z(), other.z());
    }
    return a == b;
}

} // namespace ripstop
