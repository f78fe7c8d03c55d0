#pragma once

#include "actions/menu_row.h"

#include <vector>

namespace ripstop {

struct Workbench;

// The Insert menu: a row for each builder.
std::vector<MenuRow> insertRows(const Workbench& bench);

} // namespace ripstop
