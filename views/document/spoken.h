// Numbers with their units as people say them: 0.8 mm, 40 g/m², 24 kN, never 8e-04 m.
//
// The unit gets the prefix that leaves a number one can say, where typedNumber() reads that unit,
// so that what is shown can be typed. There are no exponents and no zeros at the end. What is below
// what the engine holds is nothing: positions of metres are known to about 1e-12 m, and what is
// worked out of their differences, pulls and strains, to a thousand times that. Readouts and fields
// of all panels take their numbers from here; only the window's thread uses it, as its language
// says what the decimal point is.
#pragma once

#include "base/quantity.h"

#include <QString>

#include <string_view>

namespace ripstop {

struct Spoken
{
    QString number;
    QString unit; // empty for plain numbers

    QString text() const; // joined by a space that does not break
};

// `value` is in `unit`; `digits` are those that count.
Spoken spoken(double value, std::string_view unit, int digits = 4);

// The same as one text; a dash for what is no number.
QString spokenText(double value, std::string_view unit, int digits = 4);

// What a probe of this quantity reads: strains are said in percent.
QString readingText(Quantity quantity, double value, std::string_view unit, int digits = 4);

// For a field, which has its unit beside the number: only numbers that cannot be said in that unit
// get another one, as a part of the text, so that a bare number is always in the field's own unit.
Spoken spokenInField(double value, std::string_view unit);

} // namespace ripstop
