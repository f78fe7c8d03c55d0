// How conditions are written: text into clauses. What keys and values mean is not known here but
// in condition.cpp, the only user.
#pragma once

#include "base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

enum class Comparison { None, Equal, NotEqual, Less, NotMore, More, NotLess };

// Places count characters from 0.
struct Clause
{
    bool negated = false; // "not pinned"
    std::string key;
    std::size_t keyAt = 0;
    Comparison comparison = Comparison::None;
    std::size_t comparisonAt = 0;
    std::string value; // with its unit
    std::size_t valueAt = 0;
};

// "At character 8: ...", of a place counted from 0.
Failure failureAt(std::size_t place, const Message& what);

// One or more clauses with "and" between them. A failure names the place.
Result<std::vector<Clause>> clausesOf(std::string_view text);

} // namespace ripstop
