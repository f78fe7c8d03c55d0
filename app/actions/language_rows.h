// The choice of a language in the View menu.
#pragma once

#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

struct Workbench;

// What is chosen is kept, and heard at the next start.
std::vector<MenuRow> languageRows(const Workbench& bench);

} // namespace ripstop
