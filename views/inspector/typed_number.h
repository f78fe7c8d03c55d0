// What people type into a field of numbers.
//
//     12   12 kg   1/240   0,5   5%     the value itself
//     *1.1   /2   +5%   -5%             each value times a factor
//     +0.2   +=0.2   -=0.2              each value plus a term
//
// A minus alone is a sign, so that coordinates can be typed as they are.
#pragma once

#include "inspector/subject.h"

namespace ripstop {

struct TypedNumber
{
    enum class Sort { Absolute, Times, Plus };
    Sort sort;
    double number;

    double appliedTo(double before) const;
};

std::optional<TypedNumber> typedNumber(QString text, const QString& unit = {});

// The transform of a number, or of one axis of a vector. Relative changes of
// whole numbers are rounded; an absent value stays absent.
Transform transformOf(TypedNumber typed, int axis = 0);

Transform setTo(Value value);

} // namespace ripstop
