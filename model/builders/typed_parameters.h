// Parameters of builders as people type them: KEY=VALUE on a command line, in a study, from Python.
#pragma once

#include "builders/builder.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

std::string listed(std::span<const std::string_view> choices); // "ideal, ripstop_050"

// A number, with a unit where one likes (scene/typed_number.h), or a choice by its name or its
// number.
Result<double> parameterValue(const Builder& builder, std::string_view key, std::string_view text);

// "span=2.4"; a table as "lengths=1.2, 0.5; 1.1, 0.4", or "lengths=@FILE" for what stands in a
// file.
Result<Parameters> parametersFrom(const Builder& builder, const std::vector<std::string>& texts);

} // namespace ripstop
