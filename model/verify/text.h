#pragma once

#include <string_view>

namespace ripstop {

// Small and capital letters are alike.
bool containsText(std::string_view text, std::string_view part);

} // namespace ripstop
