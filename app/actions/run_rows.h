#pragma once

#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

class Actions;
struct Workbench;

// What is done to a run by hand, and what is made of it.
std::vector<MenuRow> handRows(const Workbench& bench, const Actions& actions);

} // namespace ripstop
