// What people type where a number is wanted: the one reader of fields, dialogs, conditions, tables
// and the command line.
//
//     12   25 g   2*15 cm   1/240 s   0,5   5 %     the value itself
//     *1.1   /2   +5 %   -5 %                       each value times a factor
//     +0.2   +=2 cm   -=0.2                         each value plus a term
//
// A minus alone is a sign, so that coordinates can be typed as they are. A number without a unit is
// in the unit that is wanted.
#pragma once

#include "scene/property.h"

namespace ripstop {

struct TypedNumber
{
    enum class Sort { Absolute, Times, Plus };
    Sort sort;
    double number; // in the wanted unit; a factor has none

    double appliedTo(double before) const;
};

struct Typed
{
    std::optional<TypedNumber> number;
    Message complaint;  // half a sentence when there is none: "must be in kg, g or t, not in m"
    std::size_t at = 0; // character that the complaint is about, from 0
    std::string unit;   // the unit that does not fit, if that is it
};

// `unit` is the wanted one, as in the table of properties; empty for a pure number.
Typed typedNumber(std::string_view text, std::string_view unit);

// What a comma with three digits behind it is, in "7,000": the window shows decimal commas where
// its language has them, and reads them again. Command lines and studies are written with points,
// and whoever writes a comma there may mean thousands: it is refused, and 0,5 and 1,25 are not.
enum class ThreeDigits { AreDecimals, AreRefused };

// Reads a value where there is none to change: a factor or a term (+=, -=) is refused, and a plain
// plus before the number is a sign.
Typed typedValue(std::string_view text, std::string_view unit,
                 ThreeDigits behindComma = ThreeDigits::AreDecimals);

// A number, or one axis of a vector, after the change. Relative changes of whole numbers are
// rounded; an absent value stays absent unless it is given one.
Value changed(const Value& before, const TypedNumber& typed, int axis = 0);

// The unit of the property of this thing: that of a tear limit is what the tear rule of its
// material compares with.
std::string_view unitOf(const Scene& scene, const Property& property, const ConstRef& ref);

// Reads a value as valueFromText() of property.h does. Numbers without a unit of their own are in
// `unit`.
Result<Value> valueFromText(const Property& property, std::string_view text, std::string_view unit,
                            ThreeDigits behindComma = ThreeDigits::AreDecimals);

} // namespace ripstop
