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

// One unit for numbers that stand together, on an axis or in a column.
struct SpokenScale
{
    double factor = 1.0; // of a number that is said, to the unit of the values
    QString unit;        // that it is said in

    QString number(double value, int digits = 4) const; // as many as count
    QString atStep(double value, double step) const;    // as many as the step between them needs
};

// That in which the largest of them is said; shares (`isShare`) are said in percent.
SpokenScale spokenScale(double largest, std::string_view unit, bool isShare = false);

// The smallest of 1, 2 and 5 times a power of ten that is not below this; 0 for nothing.
double roundStep(double least);

// Zero for what is less than what the engine holds.
double heldValue(double value);

bool isSaidInPercent(Quantity quantity); // strains, which are shares

// The same as one text; a dash for what is no number.
QString spokenText(double value, std::string_view unit, int digits = 4);

// A number alone, without exponents, however small.
QString spokenNumber(double value, int digits = 4);

// What a probe reads: shares, such as strains, are said in percent.
QString readingText(bool isShare, double value, std::string_view unit, int digits = 4);
QString readingText(Quantity quantity, double value, std::string_view unit, int digits = 4);

// For a field, which has its unit beside the number: only numbers that cannot be said in that unit
// get another one, as a part of the text, so that a bare number is always in the field's own unit.
Spoken spokenInField(double value, std::string_view unit);

} // namespace ripstop
