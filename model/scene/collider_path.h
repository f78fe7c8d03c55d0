// The text of a collider's path: "time: x y z; time: x y z; ...", s and m, times ascending.
#pragma once

#include "base/path_key.h"
#include "base/result.h"

#include <string_view>
#include <vector>

namespace ripstop {

// Empty for an empty text. The message is half a sentence, as refusal() has it.
Result<std::vector<PathKey>> pathFromText(std::string_view text);

} // namespace ripstop
