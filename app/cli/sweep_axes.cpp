// sweepAxis() splits the text at its first "=", tries it as a range FROM:STEP:TO, and else takes it
// as a list; a semicolon separates values that have commas themselves. Every failure says what to
// write instead. combinations() extends what it has by one axis after the other, so that the last
// one changes fastest.
#include "cli/sweep_axes.h"

#include "study/point_scene.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

namespace ripstop {
namespace {

constexpr double mostValues = 1e5;

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.emplace_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

std::optional<double> numberOf(const std::string& text)
{
    double number = 0.0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::string textOf(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", number); // 0.3 for three steps of 0.1
    return text;
}

Failure wrong(std::string_view text, const Message& why)
{
    return Failure("--sweep %1: %2", text, why);
}

} // namespace

Result<SweepAxis> sweepAxis(std::string_view text)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || trimmed(text.substr(0, equals)).empty())
        return wrong(text, Message("write PATH=VALUES, like settings.timeStep=0.001,0.002."));
    SweepAxis axis{std::string(trimmed(text.substr(0, equals))), {}};
    const std::string_view values = trimmed(text.substr(equals + 1));

    const std::vector<std::string> ends = split(values, ':');
    if (ends.size() == 3 && values.find_first_of(",;") == std::string_view::npos) {
        const auto from = numberOf(ends[0]), step = numberOf(ends[1]), to = numberOf(ends[2]);
        if (!from || !step || !to)
            return wrong(text, Message("a range is FROM:STEP:TO, three numbers."));
        const double exactly = *step == 0.0 ? -1.0 : (*to - *from) / *step;
        if (!(exactly >= 0.0))
            return wrong(text, Message("the range has no value: its step must lead from its start "
                                       "to its end, and %1 does not.",
                                       textOf(*step)));
        if (exactly >= mostValues)
            return wrong(text, Message("the range has %1 values, and %2 can be flown at most: take "
                                       "a larger step.",
                                       textOf(std::floor(exactly) + 1.0), textOf(mostValues)));
        const double steps = std::rint(exactly);
        constexpr double rounding = 1e-6; // of a step, as in 0:0.3333333:1
        if (std::abs(exactly - steps) > rounding) {
            const double last = *from + std::floor(exactly) * *step;
            return wrong(text, Message("the steps do not meet the end of the range, which has both "
                                       "ends: they come to %1 and %2. End it with one of these, or "
                                       "list the values.",
                                       textOf(last), textOf(last + *step)));
        }
        for (int i = 0; i <= int(steps); ++i)
            axis.values.push_back(textOf(*from + i * *step));
        return axis;
    }
    const bool isOne = values.ends_with(';') && values.find(';') == values.size() - 1; // "8,0,0;"
    axis.values = isOne ? std::vector{std::string(trimmed(values.substr(0, values.size() - 1)))}
                        : split(values, values.find(';') == std::string_view::npos ? ',' : ';');
    for (const std::string& value : axis.values)
        if (value.empty())
            return wrong(
                text, Message("a value is missing; write PATH=100,200,400 or PATH=FROM:STEP:TO."));
    return axis;
}

std::optional<Failure> checkValues(const Scene& scene, const std::string& path,
                                   const std::vector<std::string>& values)
{
    for (const std::string& value : values) {
        const auto failure = checkAssignment(scene, path + '=' + value);
        if (!failure)
            continue;
        const Message reason("%1=%2: %3", path, value, failure->message);
        if (values.size() < 3)
            return Failure(reason);
        const std::string vector = values[0] + ',' + values[1] + ',' + values[2];
        if (checkAssignment(scene, path + '=' + vector))
            return Failure(reason);
        return Failure("%1. Values that have commas themselves are separated by ; as in "
                       "\"%2=8,0,0; 6,0,0\", and one of them is \"%3=%4;\".",
                       reason, path, path, vector);
    }
    return std::nullopt;
}

std::vector<std::vector<std::string>> combinations(const std::vector<SweepAxis>& axes)
{
    std::vector<std::vector<std::string>> all{{}};
    for (const SweepAxis& axis : axes) {
        std::vector<std::vector<std::string>> longer;
        for (const auto& begun : all)
            for (const std::string& value : axis.values) {
                longer.push_back(begun);
                longer.back().push_back(value);
            }
        all = std::move(longer);
    }
    return all;
}

} // namespace ripstop
