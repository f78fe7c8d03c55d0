// Numbers as people write them: a sum, a product, units.
//
//     25 g     2*15 cm     1/240 s     3 m + 20 cm     (1.2 m)/3     0,5     sqrt(2) m     30 km/h
//
// muParser works out the value. That what is added measures the same is found as a physicist would:
// a quantity is measured once more with each basic unit made smaller, and the power by which its
// number grows is its dimension; a sum of unlike things grows by no power at all.
#pragma once

#include "scene/units.h"

namespace ripstop {

struct Measured
{
    double value; // SI
    Dimension dimension;
    bool hasUnit = true; // else it is in any unit that is wanted
};

// Why a text is no quantity.
struct ExpressionFault
{
    enum class Sort { NotANumber, UnknownUnit, UnlikeSum, WrongUnit };
    Sort sort = Sort::NotANumber;
    std::size_t at = 0; // character, from 0
    std::string word;   // the unit in question
};

// What a text means where a quantity like `wanted` is asked for. In 1/240 s the unit belongs to the
// fraction where a time is wanted, and to its lower part where a rate is.
struct Expression
{
    std::optional<Measured> quantity;
    ExpressionFault fault; // when there is none
};
Expression evaluate(std::string_view text, const Dimension& wanted);

// What one of this unit measures, as "km/h"; nothing when a name in it is no unit. An empty text is
// the unit of pure numbers.
std::optional<Measured> measureOfUnit(std::string_view unit);

} // namespace ripstop
