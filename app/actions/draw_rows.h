#pragma once

#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

struct Workbench;

// The actions that draw: rows of the table in actions.cpp.
std::vector<MenuRow> drawRows(const Workbench& bench);

} // namespace ripstop
