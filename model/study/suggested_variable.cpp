#include "study/suggested_variable.h"

#include "scene/path.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::array shares{0.5, 0.75, 1.0, 1.25, 1.5}; // of a vector

// Half of the value to twice of it, by even factors; of zero the usual range.
SliderRange rangeOf(const Property& property, double value)
{
    if (!(std::abs(value) > 0.0))
        return rangeAround(property, value);
    SliderRange range{0.5 * value, 2.0 * value, value > 0.0};
    if (value < 0.0)
        std::swap(range.low, range.high);
    range.low = std::max(range.low, property.range.low);
    range.high = std::min(range.high, property.range.high);
    return range;
}

// That of the slider. One that nobody has chosen may span five decades, as that of strengths does,
// of which a few values would miss all that is of interest: of such a one a decade either way.
SliderRange rangeOf(const Property& property, double value, const SliderRange& slider)
{
    constexpr double wide = 1e3;
    const bool isUsual = slider == rangeAround(property, value);
    if (!isUsual || !slider.logarithmic || !(value > 0.0) || slider.high <= wide * slider.low)
        return slider;
    return {std::max(slider.low, value / 10.0), std::min(slider.high, value * 10.0), true};
}

StudyVariable ofRange(const SliderRange& range)
{
    // a logarithmic slider may begin at zero, a study may not
    const bool isLogarithmic = range.logarithmic && range.low > 0.0;
    return rangeVariable(range.low, range.high, suggestedSteps, isLogarithmic);
}

std::vector<std::string> wholeNumbers(const SliderRange& range)
{
    std::vector<std::string> values;
    for (int i = 0; i < suggestedSteps; ++i) {
        const double value =
            std::round(range.low + (range.high - range.low) * i / double(suggestedSteps - 1));
        if (std::string text = std::to_string(std::int64_t(value));
            values.empty() || values.back() != text)
            values.push_back(std::move(text));
    }
    return values;
}

} // namespace

Result<StudyVariable> suggestedVariable(const Scene& scene, const Property& property,
                                        const std::vector<Id>& ids,
                                        const std::optional<SliderRange>& range)
{
    const auto thing = ids.empty() ? std::nullopt : find(scene, ids.front());
    if (!thing)
        return Failure("There is nothing of which %1 could be varied.", property.key);
    const Value value = property.get(*thing);
    StudyVariable variable;
    if (const auto* number = std::get_if<double>(&value))
        variable = ofRange(range ? rangeOf(property, *number, *range) : rangeOf(property, *number));
    else if (const auto* whole = std::get_if<int>(&value))
        variable.values = wholeNumbers(range.value_or(rangeOf(property, *whole)));
    else if (std::holds_alternative<bool>(value))
        variable.values = {"true", "false"};
    else if (const auto* vector = std::get_if<Vec3>(&value))
        for (const double share : shares)
            variable.values.push_back(textFromValue(Vec3(*vector * share)));
    else if (!property.choices.empty())
        variable.values.assign(property.choices.begin(), property.choices.end());
    else
        return Failure("%1 cannot be varied: it is no number, vector, switch or choice that is "
                       "there.",
                       property.key);
    for (const Id id : ids)
        variable.paths.push_back(pathOf(scene, id, property));
    variable.name = variable.paths.front();
    return variable;
}

} // namespace ripstop
