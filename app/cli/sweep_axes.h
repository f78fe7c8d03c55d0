// What the command sweep varies: a text "PATH=VALUES" becomes a property and a list of values, and
// several of them become all combinations. Values stay texts, as --set takes them, so that a sweep
// can vary whatever --set can change.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

struct SweepAxis
{
    std::string path;
    std::vector<std::string> values; // as --set takes them
};

// Reads an axis. VALUES is "100,200,400", or "FROM:STEP:TO" with both ends, or "8,0,0; 6,0,0" where
// values have commas themselves, "8,0,0;" for one of them.
Result<SweepAxis> sweepAxis(std::string_view text);

// Whether each of these values can be set in the scene; the failure names the one that cannot, and
// says what separates vectors where commas have taken one apart.
std::optional<Failure> checkValues(const Scene& scene, const std::string& path,
                                   const std::vector<std::string>& values);

// The values of each axis in all combinations, the last one changing fastest; one empty combination
// without axes.
std::vector<std::vector<std::string>> combinations(const std::vector<SweepAxis>& axes);

} // namespace ripstop
