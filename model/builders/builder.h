// Builders: parametric designs.
//
// A builder is one row of a table: its parameters with unit, default and range, and a function
// that turns values into a whole scene. The command line, the Insert menu and the manual are made
// from the rows.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace ripstop {

struct Parameter
{
    std::string_view key;
    std::string_view unit; // SI; empty for counts and switches
    double initial;
    double low;
    double high;
    bool whole; // counts and switches (0 or 1)
    std::string_view help;
};

using Parameters = std::map<std::string, double>;

struct Builder
{
    std::string_view name;
    std::string_view label; // on screen
    std::string_view help;
    std::span<const Parameter> parameters;
    Scene (*build)(const Parameters&); // every parameter is there and in range
};

std::span<const Builder> allBuilders();
const Builder* findBuilder(std::string_view name); // null when there is none

// Fills in defaults and checks names and ranges, then builds.
Result<Scene> build(const Builder& builder, const Parameters& given);

} // namespace ripstop
