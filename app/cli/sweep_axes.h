// What a sweep varies: "PATH=VALUES" as a list of values.
#pragma once

#include "base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

struct SweepAxis
{
    std::string path;
    std::vector<std::string> values; // as --set takes them
};

// VALUES is "100,200,400", or "FROM:STEP:TO" with both ends, or "8,0,0; 6,0,0" where values have
// commas themselves.
Result<SweepAxis> sweepAxis(std::string_view text);

// The values of each axis in all combinations, the last one changing fastest; one empty combination
// without axes.
std::vector<std::vector<std::string>> combinations(const std::vector<SweepAxis>& axes);

} // namespace ripstop
