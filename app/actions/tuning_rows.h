// What is done to numbers from a menu or a key: sliders, sets of values, tables.
#pragma once

#include "actions/actions.h"
#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

std::vector<MenuRow> tuningActionRows(const Workbench& bench);

} // namespace ripstop
