// The text of a collider's path: "time: x y z; time: x y z; ...", in s and m, with ascending
// times. The property table accepts a path by it, the check of colliders reports one, and
// compiling turns it into keys.
#pragma once

#include "base/path_key.h"
#include "base/result.h"

#include <string_view>
#include <vector>

namespace ripstop {

// The keys of the path; none for an empty text. The message of a failure is half a sentence, as
// that of refusal() in property.h.
Result<std::vector<PathKey>> pathFromText(std::string_view text);

} // namespace ripstop
