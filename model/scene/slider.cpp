// Sliders in three stages: reading one from text word by word (property, ids, range), with a
// failure that quotes the word at fault; the ranges themselves (a fitting one around a value, what
// a property refuses, and the way between a place on the track and a value, linear or by decades);
// and the list of sliders as one text, both ways, without things that are gone.
// Values along a track have three digits and go through text, so that what a drag leaves is what a
// person would have typed.
#include "scene/slider.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

std::string numberText(double value)
{
    char text[32];
    const char* end = std::to_chars(text, text + sizeof text, value).ptr;
    return std::string(text, std::size_t(end - text));
}

// Three digits are enough for a number that a hand drags. It is rounded through text, so that 0.3
// is the 0.3 that people type.
double rounded(double value)
{
    if (!std::isfinite(value))
        return value;
    char text[32];
    const char* end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr;
    std::from_chars(text, end, value);
    return value;
}

std::vector<std::string_view> wordsOf(std::string_view text)
{
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0)
            words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

template <typename Number>
std::optional<Number> numberIn(std::string_view word)
{
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size() ? std::optional(number)
                                                                    : std::nullopt;
}

Failure broken(std::string_view part, const Message& why)
{
    return Failure("must be sliders such as material.stiffness #17 1 1000 log; \"%1\" %2", part,
                   why);
}

const Property* propertyNamed(std::string_view name)
{
    const std::size_t dot = name.find('.');
    const auto kind = kindFromName(name.substr(0, dot));
    return kind && dot != name.npos ? findProperty(*kind, name.substr(dot + 1)) : nullptr;
}

Result<Slider> sliderFromText(std::string_view text)
{
    const std::vector<std::string_view> words = wordsOf(text);
    Slider slider{propertyNamed(words.front()), {}, {}};
    if (!slider.property || !canBeTuned(*slider.property))
        return broken(words.front(), Message("is no property that can be tuned"));
    std::size_t next = 1;
    for (; next < words.size() && words[next].starts_with('#'); ++next) {
        const auto id = numberIn<std::uint32_t>(words[next].substr(1));
        if (!id)
            return broken(words[next], Message("is no id"));
        slider.ids.push_back(Id{*id});
    }
    if (slider.property->kind == Kind::Settings)
        slider.ids = {settingsId};
    std::ranges::sort(slider.ids);
    slider.ids.erase(std::unique(slider.ids.begin(), slider.ids.end()), slider.ids.end());
    if (slider.ids.empty() || slider.ids.size() > mostOfASlider)
        return broken(text, slider.ids.empty() ? Message("names nothing")
                                               : Message("names too many things"));
    if (!hasRange(*slider.property))
        return next == words.size() ? Result<Slider>(slider)
                                    : broken(text, Message("needs no range"));
    const auto low = next < words.size() ? numberIn<double>(words[next++]) : std::nullopt;
    const auto high = next < words.size() ? numberIn<double>(words[next++]) : std::nullopt;
    const bool isLog = next < words.size() && words[next] == "log";
    if (!low || !high || next + (isLog ? 1 : 0) != words.size())
        return broken(text, Message("needs two numbers as its range"));
    slider.range = {*low, *high, isLog};
    if (const auto reason = refusal(*slider.property, slider.range))
        return broken(text, Message("has a range that %1", *reason));
    return slider;
}

bool isOfKind(const Scene& scene, Id id, Kind kind)
{
    const auto ref = find(scene, id);
    return ref && kindOf(*ref) == kind;
}

} // namespace

bool hasRange(const Property& property)
{
    return property.optional || std::holds_alternative<double>(property.initial)
           || std::holds_alternative<int>(property.initial)
           || std::holds_alternative<Vec3>(property.initial);
}

bool canBeTuned(const Property& property)
{
    return hasRange(property) || std::holds_alternative<bool>(property.initial)
           || !property.choices.empty();
}

SliderRange rangeAround(const Property& property, double value)
{
    if (const auto range = property.usual;
        range && value <= range->high && (value >= range->low || range->logarithmic))
        return *range;
    const Range& allowed = property.range;
    const bool isWhole = std::holds_alternative<int>(property.initial);
    const bool isBounded = std::isfinite(allowed.low) && std::isfinite(allowed.high);
    SliderRange range{0.0, rounded(4.0 * std::abs(value)), false};
    if (value == 0.0)
        range.high = isWhole ? 10.0 : 1.0;
    if (isBounded && allowed.high <= 100.0)
        range = {allowed.low, allowed.high, allowed.low > 0.0 && allowed.high > 1e3 * allowed.low};
    else if (allowed.low >= 0.0 && value > 0.0)
        range = {isWhole ? 1.0 : rounded(value / 30.0), rounded(value * 30.0), true};
    else if (std::holds_alternative<double>(property.initial) && allowed.low < 0.0)
        range.low = -range.high;
    return {std::max(range.low, allowed.low), std::min(range.high, allowed.high),
            range.logarithmic};
}

std::optional<Message> refusal(const Property& property, const SliderRange& range)
{
    const bool isVector = std::holds_alternative<Vec3>(property.initial);
    if (!std::isfinite(range.low) || !std::isfinite(range.high))
        return Message("must have finite ends");
    if (!(range.low < range.high))
        return Message("must rise from left to right");
    if (range.logarithmic && !(range.low > 0.0))
        return Message("must begin above 0 to be logarithmic");
    if (range.low < (isVector ? 0.0 : property.range.low))
        return Message("must begin at %1 or above",
                       Message::number(numberText(isVector ? 0.0 : property.range.low)));
    if (range.high > property.range.high)
        return Message("must end at %1 or below", Message::number(numberText(property.range.high)));
    return std::nullopt;
}

double valueAt(const SliderRange& range, double place)
{
    if (!range.logarithmic)
        return rounded(range.low + place * (range.high - range.low));
    const bool hasZero = range.low < 1.0;
    return hasZero && place <= 0.0 ? 0.0
                                   : rounded(range.low * std::pow(range.high / range.low, place));
}

double placeOf(const SliderRange& range, double value)
{
    if (!range.logarithmic)
        return std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
    if (value <= range.low)
        return 0.0;
    return std::min(std::log(value / range.low) / std::log(range.high / range.low), 1.0);
}

Result<std::vector<Slider>> slidersFromText(std::string_view text)
{
    std::vector<Slider> sliders;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view part = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (part.find_first_not_of(' ') == part.npos)
            continue;
        auto slider = sliderFromText(part);
        if (!slider)
            return slider.failure();
        sliders.push_back(std::move(*slider));
    }
    return sliders;
}

std::string textOf(const std::vector<Slider>& sliders)
{
    std::string text;
    for (const Slider& slider : sliders) {
        const Property& property = *slider.property;
        if (!text.empty())
            text += "; ";
        text.append(kindName(property.kind)).append(1, '.').append(property.key);
        if (property.kind != Kind::Settings)
            for (const Id id : slider.ids)
                text.append(" #").append(std::to_string(std::uint32_t(id)));
        if (!hasRange(property))
            continue;
        for (const double end : {slider.range.low, slider.range.high})
            text.append(1, ' ').append(numberText(end));
        if (slider.range.logarithmic)
            text.append(" log");
    }
    return text;
}

std::vector<Slider> existing(const Scene& scene, std::vector<Slider> sliders)
{
    for (Slider& slider : sliders)
        std::erase_if(slider.ids,
                      [&](Id id) { return !isOfKind(scene, id, slider.property->kind); });
    std::erase_if(sliders, [](const Slider& slider) { return slider.ids.empty(); });
    return sliders;
}

} // namespace ripstop
