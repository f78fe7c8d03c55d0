#pragma once

#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

struct Workbench;

// The actions that shape the design: rows of the table in actions.cpp.
std::vector<MenuRow> designRows(const Workbench& bench);

} // namespace ripstop
