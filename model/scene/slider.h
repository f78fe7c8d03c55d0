// The sliders of a design: which of its numbers are at hand while it runs, and over which range.
//
// They belong to the scene, because they name its things and because who gets the file wants to
// turn the same knobs; nothing that is computed depends on them. In a file they are one text:
//
//     material.stiffness #17 1 100000 log; particle.mass #3 #4 0 1; settings.sweeps 1 256
//
// A choice or a switch has no range.
#pragma once

#include "scene/property.h"

namespace ripstop {

struct Slider
{
    const Property* property;
    std::vector<Id> ids; // ascending, of the property's kind
    SliderRange range;

    friend bool operator==(const Slider&, const Slider&) = default;
};

// A slider writes to each of its things at each step of a drag; more of them are better made a
// material or a group.
inline constexpr std::size_t mostOfASlider = 200;

bool hasRange(const Property& property);   // numbers and vectors
bool canBeTuned(const Property& property); // numbers, vectors, switches, choices

// The usual range of the property table, or one around the value where the table has none or the
// value is above it.
SliderRange rangeAround(const Property& property, double value);

// Why the property cannot have this range, as half a sentence, or nothing.
std::optional<Message> refusal(const Property& property, const SliderRange& range);

double valueAt(const SliderRange& range, double place); // place 0..1 along the track; three digits
double placeOf(const SliderRange& range, double value);

// The sliders of a text, and the text of sliders. The message of a failure is half a sentence, as
// that of refusal().
Result<std::vector<Slider>> slidersFromText(std::string_view text);
std::string textOf(const std::vector<Slider>& sliders);

// The sliders that still have something to write to. Ids of things that are gone are left out.
std::vector<Slider> existing(const Scene& scene, std::vector<Slider> sliders);

} // namespace ripstop
