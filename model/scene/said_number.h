// Numbers with their units as people say them: 0.8 mm, 206 g, 24 kN, never 8e-04 m.
//
// The unit gets the prefix that leaves a number one can say, where typedNumber() reads that unit,
// so that what is shown can be typed. Sentences of the model take their numbers from here, and so
// do readouts and fields of the window (views/document/spoken.h), which add the decimal point of
// its language.
#pragma once

#include "base/message.h"

#include <string>
#include <string_view>

namespace ripstop {

struct NumberInUnit
{
    double number;
    std::string unit;
};

// In the unit that readouts have.
NumberInUnit inReadableUnit(double value, std::string_view unit);

// Likewise, but in the unit itself from `least` to `most`.
NumberInUnit inReadableUnit(double value, std::string_view unit, double least, double most);

// A unit for numbers that stand together: that of the largest.
struct ReadableUnit
{
    double factor = 1.0; // of a number in it, to one in the unit that was asked about
    std::string name;
};

ReadableUnit readableUnit(double largest, std::string_view unit);

inline constexpr double mostDigits = 1e15; // from here on a double does not know the last digit

// As many digits as count, without zeros at the end, and without exponents below 1e15: what is more
// would be a row of digits that mean nothing, and is nothing that flies.
std::string plainNumber(double number, int digits);

// Whether it is less than what the engine holds: positions of metres are known to about 1e-12 m,
// and what is worked out of their differences, pulls and strains, to a thousand times that. Lengths
// are nothing below 10 nm, as what lies on the ground does so no more exactly, and shares in
// percent below a millionth: no fabric is measured as finely.
bool isNothing(double value, std::string_view unit = {});

// "206.3 g"; a dash for what is no number.
Message saidNumber(double value, std::string_view unit, int digits = 4);

} // namespace ripstop
